#include "update/override_choice.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

// Two clouds, three regions: the second goes by the first cloud, the third by the second.
RegionChoice choice_of_three() {
  RegionChoice choice;
  choice.replaced = IdVector<RegionId, std::uint8_t>(std::vector<std::uint8_t>{0, 1, 1});
  choice.clouds = {{{{RegionId(0), 3, 10, false}, {RegionId(1), 0.1, 10, true}}},
                   {{{RegionId(0), 3, 10, false}, {RegionId(2), 0.1, 10, true}}}};
  return choice;
}

std::vector<int> replaced(const RegionChoice& choice) {
  return {choice.replaced.begin(), choice.replaced.end()};
}

TEST(OverrideChoice, EntersWhatIsSaidForEveryCloudThatSawIt) {
  RegionChoice choice = choice_of_three();
  override_choice({.replaced = {RegionId(0)}, .kept = {RegionId(2)}}, choice);
  EXPECT_EQ(replaced(choice), (std::vector<int>{1, 1, 0}));
  EXPECT_TRUE(choice.clouds[0].regions[0].under_cloud);
  EXPECT_TRUE(choice.clouds[1].regions[0].under_cloud);
  EXPECT_TRUE(choice.clouds[0].regions[1].under_cloud);
  EXPECT_FALSE(choice.clouds[1].regions[1].under_cloud);
}

TEST(OverrideChoice, WithoutAnythingSaidNothingChanges) {
  RegionChoice choice = choice_of_three();
  choice.status = ChoiceStatus::ambiguous;
  override_choice({}, choice);
  EXPECT_EQ(choice.status, ChoiceStatus::ambiguous);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 1, 1}));
}

// Cloud 1 cannot tell regions 0 and 2 apart; by cloud 0 region 1 goes.
RegionChoice ambiguous_choice() {
  RegionChoice choice = choice_of_three();
  choice.status = ChoiceStatus::ambiguous;
  choice.clouds[1].is_ambiguous = true;
  choice.replaced = IdVector<RegionId, std::uint8_t>(3, 0);
  choice.replaced_by_clear = IdVector<RegionId, std::uint8_t>(std::vector<std::uint8_t>{0, 1, 0});
  return choice;
}

TEST(OverrideChoice, OfAnAmbiguousCloudThoseGoThatAreNamed) {
  RegionChoice choice = ambiguous_choice();
  override_choice({.replaced = {RegionId(2)}}, choice);
  EXPECT_EQ(choice.status, ChoiceStatus::ok);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 1, 1}));
  EXPECT_TRUE(choice.clouds[0].regions[1].under_cloud);
  EXPECT_TRUE(choice.clouds[1].regions[1].under_cloud);

  choice = ambiguous_choice();  // nothing goes there
  override_choice({.kept = {RegionId(0), RegionId(2)}}, choice);
  EXPECT_EQ(choice.status, ChoiceStatus::ok);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 1, 0}));
  EXPECT_FALSE(choice.clouds[1].regions[1].under_cloud);
}

TEST(OverrideChoice, WhatDecidesNoAmbiguousCloudLeavesItSo) {
  for (const RegionOverrides& overrides :
       {RegionOverrides{.kept = {RegionId(0)}}, RegionOverrides{.replaced = {RegionId(1)}}}) {
    RegionChoice choice = ambiguous_choice();
    override_choice(overrides, choice);
    EXPECT_EQ(choice.status, ChoiceStatus::ambiguous);
    EXPECT_EQ(replaced(choice), (std::vector<int>{0, 0, 0}));
  }
}

TEST(OverrideChoice, RefusesWhatCannotBe) {
  RegionChoice choice = choice_of_three();
  EXPECT_THROW(override_choice({.replaced = {RegionId(3)}}, choice), InputError);
  EXPECT_THROW(override_choice({.kept = {RegionId()}}, choice), InputError);
  EXPECT_THROW(override_choice({.replaced = {RegionId(1)}, .kept = {RegionId(1)}}, choice),
               InputError);
  EXPECT_THROW(override_choice({.replaced = {RegionId(0)}}, choice), InputError);
  RegionChoice none;
  EXPECT_THROW(override_choice({.kept = {RegionId(0)}}, none), InputError);
}

// Both regions lie under a cloud; the second, with the larger mean, is kept.
RegionChoice choice_of_all() {
  RegionChoice choice;
  choice.replaced = IdVector<RegionId, std::uint8_t>(std::vector<std::uint8_t>{1, 0});
  choice.kept_largest = RegionId(1);
  choice.clouds = {{{{RegionId(0), 0.1, 10, true}, {RegionId(1), 1, 10, false}}},
                   {{{RegionId(0), 1, 10, false}, {RegionId(1), 0.5, 10, true}}}};
  return choice;
}

// What was kept only since all others went, goes if another one is said to stay.
TEST(OverrideChoice, TheOneThatWasKeptLastIsDecidedAnew) {
  RegionChoice choice = choice_of_all();
  override_choice({.kept = {RegionId(0)}}, choice);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 1}));
  EXPECT_TRUE(choice.kept_largest.is_none());

  choice = choice_of_all();
  override_choice({.replaced = {RegionId(0)}}, choice);
  EXPECT_EQ(replaced(choice), (std::vector<int>{1, 0}));
  EXPECT_EQ(choice.kept_largest, RegionId(1));

  choice = choice_of_all();
  const std::vector<RegionId> islands = {RegionId(0)};
  override_choice({.kept = {RegionId(0)}}, choice, islands);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 0}));
  EXPECT_EQ(choice.kept_largest, RegionId(1));

  choice = choice_of_all();
  EXPECT_THROW(override_choice({.replaced = {RegionId(1)}}, choice), InputError);
}

}  // namespace
}  // namespace cocoon
