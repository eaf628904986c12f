#include "update/choose_regions.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <utility>

#include "geom/errors.h"

namespace cocoon {
namespace {

constexpr double degree = std::numbers::pi / 180;

// One loop of a cloud; means in degrees, region by region; no edges where the mean is negative.
RegionAngles loop(std::uint32_t cloud, const std::vector<double>& means, std::size_t edges = 100) {
  RegionAngles angles;
  angles.cloud = cloud;
  for (const double mean : means) {
    const std::size_t count = mean < 0 ? 0 : edges;
    angles.regions.push_back({mean * degree * static_cast<double>(count), count});
  }
  return angles;
}

std::vector<int> replaced(const RegionChoice& choice) {
  return {choice.replaced.begin(), choice.replaced.end()};
}

// The figures of the paper's test block.
TEST(ChooseRegions, TheSmallerAngleIsReplaced) {
  const std::vector<RegionAngles> loops = {loop(0, {4.45, 173.76})};
  const RegionChoice choice = choose_regions(loops, 1);
  EXPECT_EQ(choice.status, ChoiceStatus::ok);
  EXPECT_EQ(replaced(choice), (std::vector<int>{1, 0}));
  EXPECT_NEAR(choice.clouds[0].margin, 169.31 * degree, 1e-12);
  EXPECT_EQ(choice.narrow, 0U);
  ASSERT_EQ(choice.clouds[0].regions.size(), 2U);
  EXPECT_NEAR(choice.clouds[0].regions[0].mean_angle, 4.45 * degree, 1e-12);
  EXPECT_TRUE(choice.clouds[0].regions[0].under_cloud);
  EXPECT_FALSE(choice.clouds[0].regions[1].under_cloud);
}

// Both below or both above 90 degrees: still the smaller one (a cloud that rises steeply). In the
// paper, however large it is.
TEST(ChooseRegions, OneLoopComparesAndHasNoThreshold) {
  ChoiceOptions options;
  options.turned_away = std::numbers::pi;
  for (const auto& [inside, outside] :
       {std::pair{100.0, 140.0}, std::pair{20.0, 60.0}, std::pair{85.0, 95.0}}) {
    const std::vector<RegionAngles> loops = {loop(0, {outside, inside})};
    const RegionChoice choice = choose_regions(loops, 1, options);
    EXPECT_EQ(replaced(choice), (std::vector<int>{0, 1}));
    EXPECT_EQ(choice.narrow, outside - inside < 30 ? 1U : 0U);
  }
}

std::vector<RegionId> ids(std::initializer_list<std::uint32_t> numbers) {
  std::vector<RegionId> regions;
  for (const std::uint32_t number : numbers) regions.push_back(RegionId(number));
  return regions;
}

// No side lies under the cloud: it ends before it meets the model. Other clouds stay as they are.
TEST(ChooseRegions, RegionsThatTurnAwayOnBothSidesAreAmbiguous) {
  const std::vector<RegionAngles> loops = {loop(0, {156, 140, -1}), loop(1, {170, -1, 99})};
  const RegionChoice choice = choose_regions(loops, 2);
  EXPECT_EQ(choice.status, ChoiceStatus::ambiguous);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(choice.clouds[0].turned_away, ids({0, 1}));
  EXPECT_TRUE(choice.clouds[0].is_ambiguous);
  EXPECT_TRUE(choice.clouds[1].turned_away.empty());
  EXPECT_FALSE(choice.clouds[1].is_ambiguous);
  EXPECT_EQ(choice.replaced_by_clear.raw(), (std::vector<std::uint8_t>{0, 0, 1}));
  // Told otherwise, as by its samples.
  std::vector<IdVector<RegionId, std::uint8_t>> decided(2);
  decided[0] = IdVector<RegionId, std::uint8_t>(3, 0);
  decided[0][RegionId(0U)] = 1;
  const RegionChoice told = choose_regions(loops, 2, {}, decided);
  EXPECT_EQ(told.status, ChoiceStatus::ok);
  EXPECT_EQ(replaced(told), (std::vector<int>{1, 0, 1}));
}

// Another loop of the cloud is clear, and tells of its own regions alone.
TEST(ChooseRegions, EachLoopIsLookedAtByItself) {
  const std::vector<RegionAngles> loops = {loop(0, {171, -1, 150}, 60), loop(0, {171, 2, -1}, 400)};
  const RegionChoice choice = choose_regions(loops, 1);
  EXPECT_EQ(choice.clouds[0].turned_away, ids({0, 2}));
  ASSERT_EQ(choice.clouds[0].regions.size(), 3U);
  EXPECT_TRUE(choice.clouds[0].regions[1].under_cloud);
  EXPECT_FALSE(choice.clouds[0].regions[2].under_cloud);
  // If one cannot tell its regions apart nothing but a person can.
  std::vector<RegionAngles> equal = loops;
  equal.push_back(loop(0, {-1, 60, 60.5}));
  EXPECT_TRUE(choose_regions(equal, 1).clouds[0].turned_away.empty());
  EXPECT_TRUE(choose_regions(equal, 1).clouds[0].is_ambiguous);
}

// Three regions at a clear loop, the third seen by one edge.
TEST(ChooseRegions, ARegionByTheWayTurnsNothingAway) {
  std::vector<RegionAngles> loops = {loop(0, {180, 30, 103}, 200)};
  loops[0].regions[RegionId(2U)] = {103 * degree, 1};
  EXPECT_EQ(choose_regions(loops, 1).status, ChoiceStatus::ok);
}

// The paper's airbag: three clouds I, II, III, and IV, the rest, which each of them is compared
// with.
TEST(ChooseRegions, ThreeCloudsAndTheRest) {
  const std::vector<RegionAngles> loops = {loop(0, {5, -1, -1, 170}), loop(1, {-1, 12, -1, 160}),
                                           loop(2, {-1, -1, 8, 175})};
  EXPECT_EQ(replaced(choose_regions(loops, 3)), (std::vector<int>{1, 1, 1, 0}));
}

TEST(ChooseRegions, AnnulusIsReplacedAndItsInsideKept) {
  const std::vector<RegionAngles> loops = {loop(0, {5, 170, -1}), loop(0, {9, -1, 165}, 40)};
  const RegionChoice choice = choose_regions(loops, 1);
  EXPECT_EQ(replaced(choice), (std::vector<int>{1, 0, 0}));
  EXPECT_NEAR(choice.clouds[0].regions[0].mean_angle, (500 + 360) / 140.0 * degree, 1e-12);
}

// Two clouds overlap. Regions: 0 under the first only, 1 under both, 2 under the second only, 3
// beyond both. Each cloud has the other's own region beyond its rim; it is replaced all the same.
TEST(ChooseRegions, OverlappingClouds) {
  const std::vector<RegionAngles> loops = {loop(0, {5, 7, 172, 170}), loop(1, {168, 6, 9, 171})};
  EXPECT_EQ(replaced(choose_regions(loops, 2)), (std::vector<int>{1, 1, 1, 0}));
}

TEST(ChooseRegions, EqualAnglesAreAmbiguous) {
  const std::vector<RegionAngles> loops = {loop(0, {90.1, 90.4})};
  const RegionChoice choice = choose_regions(loops, 1);
  EXPECT_EQ(choice.status, ChoiceStatus::ambiguous);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 0}));
  EXPECT_EQ(choose_regions(loops, 1, {.ambiguous_margin = 0.1 * degree}).status, ChoiceStatus::ok);
}

TEST(ChooseRegions, OneRegionAloneIsKept) {
  const std::vector<RegionAngles> loops = {loop(0, {3})};
  const RegionChoice choice = choose_regions(loops, 1);
  EXPECT_EQ(choice.status, ChoiceStatus::ok);
  EXPECT_EQ(choice.undecided_loops, 1U);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0}));
}

// A few edges that see an island do not move the midpoint, and the island has its own verdict.
TEST(ChooseRegions, IslandsAreDecidedByTheirOwnAngles) {
  RegionAngles angles = loop(0, {80, 100, 20});
  angles.regions[RegionId(2)] = {3 * 20 * degree, 3};
  const std::vector<RegionAngles> loops = {angles};
  EXPECT_EQ(replaced(choose_regions(loops, 1)), (std::vector<int>{1, 0, 1}));
}

TEST(ChooseRegions, NeverReplacesEverything) {
  const std::vector<RegionAngles> loops = {loop(0, {10, 120}), loop(1, {130, 40})};
  const RegionChoice choice = choose_regions(loops, 2);
  EXPECT_EQ(choice.kept_largest, RegionId(0));
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 1}));  // 130 is the largest mean
}

TEST(ChooseRegions, UnseenRegionsAreKept) {
  const std::vector<RegionAngles> loops = {loop(0, {10, 170, -1})};
  EXPECT_EQ(replaced(choose_regions(loops, 1)), (std::vector<int>{1, 0, 0}));
}

TEST(ChooseRegions, RejectsLoopsOfDifferentSegmentations) {
  const std::vector<RegionAngles> loops = {loop(0, {10, 170}), loop(0, {10, 170, 90})};
  EXPECT_THROW(choose_regions(loops, 1), InputError);
  const std::vector<RegionAngles> wrong_cloud = {loop(3, {10, 170})};
  EXPECT_THROW(choose_regions(wrong_cloud, 1), InputError);
}

// Where the sides were decided otherwise the angles may speak against it: no margin is below zero.
TEST(ChooseRegions, DecidedRegionsAreTaken) {
  const std::vector<RegionAngles> loops = {loop(0, {10, 170, 20})};
  using Decided = IdVector<RegionId, std::uint8_t>;
  const std::vector<Decided> as_angles = {Decided(std::vector<std::uint8_t>{1, 0, 1})};
  const RegionChoice choice = choose_regions(loops, 1, {}, as_angles);
  EXPECT_EQ(replaced(choice), (std::vector<int>{1, 0, 1}));
  EXPECT_NEAR(choice.clouds[0].margin, 155 * degree, 1e-12);
  const std::vector<Decided> otherwise = {Decided(std::vector<std::uint8_t>{0, 1, 0})};
  const RegionChoice other = choose_regions(loops, 1, {}, otherwise);
  EXPECT_EQ(replaced(other), (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(other.clouds[0].margin, 0);
  // Also of a region that no edge sees.
  const std::vector<RegionAngles> unseen = {loop(0, {10, 170, -1})};
  EXPECT_EQ(replaced(choose_regions(unseen, 1, {}, as_angles)), (std::vector<int>{1, 0, 1}));
}

// Where one region alone counts the loop tells nothing, neither of it nor of what few edges see.
TEST(ChooseRegions, ALoopThatDoesNotDecideReplacesNothing) {
  RegionAngles angles = loop(0, {120, 20});
  angles.regions[RegionId(1U)] = {3 * 20 * degree, 3};
  const RegionChoice choice = choose_regions(std::vector{angles}, 1);
  EXPECT_EQ(choice.undecided_loops, 1U);
  EXPECT_EQ(replaced(choice), (std::vector<int>{0, 0}));
  EXPECT_EQ(choice.clouds[0].regions.size(), 2U);
  const RegionChoice unseen = choose_regions(std::vector{loop(0, {-1, -1})}, 1);
  EXPECT_EQ(unseen.status, ChoiceStatus::ok);
  EXPECT_EQ(unseen.undecided_loops, 1U);
}

// The loops of a cloud that was cut decide nothing, so they cannot be ambiguous either.
TEST(ChooseRegions, DecidedCloudsAreNotAmbiguous) {
  using Decided = IdVector<RegionId, std::uint8_t>;
  const std::vector<RegionAngles> loops = {loop(0, {90.1, 90.4})};
  const std::vector<Decided> first = {Decided(std::vector<std::uint8_t>{1, 0})};
  const RegionChoice choice = choose_regions(loops, 1, {}, first);
  EXPECT_EQ(choice.status, ChoiceStatus::ok);
  EXPECT_EQ(choice.narrow, 0U);
  EXPECT_EQ(replaced(choice), (std::vector<int>{1, 0}));
  // Nothing is seen outside: no margin.
  const std::vector<RegionAngles> one_sided = {loop(0, {10, -1})};
  EXPECT_EQ(choose_regions(one_sided, 1, {}, first).clouds[0].margin, std::numbers::pi);
}

TEST(ChooseRegions, TheLargestRegionThatStaysIsTheFirstOfSeveral) {
  Regions regions;
  for (const std::size_t facets : {9U, 5U, 5U, 4U})
    regions.regions.push_back({.first = {}, .facets = facets});
  RegionChoice choice;
  choice.replaced = IdVector<RegionId, std::uint8_t>(4, 0);
  EXPECT_EQ(largest_kept_region(regions, choice), RegionId(0U));
  choice.replaced[RegionId(0U)] = 1;
  EXPECT_EQ(largest_kept_region(regions, choice), RegionId(1U));
  choice.replaced = IdVector<RegionId, std::uint8_t>(4, 1);
  EXPECT_TRUE(largest_kept_region(regions, choice).is_none());
}

// However large they are; but each region outside is to have a mean so much larger.
TEST(SureAngles, DifferByForty) {
  const auto under = [](const std::vector<double>& means, const ChoiceOptions& options = {}) {
    const std::vector<RegionAngles> loops = {loop(0, means)};
    const auto flags = under_by_sure_angles(loops, 1, 0, options);
    return std::vector<int>(flags.begin(), flags.end());
  };
  EXPECT_EQ(under({105, 146}), (std::vector<int>{1, 0}));
  EXPECT_EQ(under({172, 131}), (std::vector<int>{0, 1}));
  EXPECT_TRUE(under({105, 144}).empty());
  EXPECT_TRUE(under({102, 121, 143}).empty());  // the second is parted from the third by 22
  EXPECT_EQ(under({102, 103, 145}), (std::vector<int>{1, 1, 0}));
  EXPECT_EQ(under({105, 144}, {.sure_margin = 0.6}), (std::vector<int>{1, 0}));
  EXPECT_TRUE(under({105, 105.5}, {.sure_margin = 0}).empty());  // ambiguous
}

TEST(SureAngles, AreThoseOfOneCloud) {
  const std::vector<RegionAngles> loops = {loop(0, {110, 120, -1}), loop(1, {160, -1, 105})};
  EXPECT_TRUE(under_by_sure_angles(loops, 2, 0).empty());
  const auto flags = under_by_sure_angles(loops, 2, 1);
  EXPECT_EQ(std::vector<int>(flags.begin(), flags.end()), (std::vector<int>{0, 0, 1}));
}

// As where all rims of a cloud that was cut are covered.
TEST(ChooseRegions, WithoutLoopsDecisionsTellTheRegions) {
  std::vector<IdVector<RegionId, std::uint8_t>> decided(2);
  decided[1] = IdVector<RegionId, std::uint8_t>(3, 0);
  decided[1][RegionId(2U)] = 1;
  EXPECT_EQ(replaced(choose_regions({}, 2, {}, decided)), (std::vector<int>{0, 0, 1}));
}

TEST(ChooseRegions, NoLoops) {
  const RegionChoice choice = choose_regions({}, 2);
  EXPECT_TRUE(choice.replaced.empty());
  EXPECT_EQ(choice.clouds.size(), 2U);
}

TEST(ChooseRegions, FlagsOfOtherRegionsAreRefused) {
  const std::vector<RegionAngles> loops = {loop(0, {10, 170})};
  const std::vector<IdVector<RegionId, std::uint8_t>> decided = {
      IdVector<RegionId, std::uint8_t>(1, 1)};
  EXPECT_THROW(choose_regions(loops, 1, {}, decided), InputError);
  Regions regions;
  regions.regions.resize(2);
  EXPECT_THROW(largest_kept_region(regions, RegionChoice()), InputError);
}

TEST(ChooseRegions, OptionsOutOfRangeAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<RegionAngles> loops = {loop(0, {10, 170})};
  for (const ChoiceOptions& options : {
           ChoiceOptions{.min_edge_share = 1.5}, ChoiceOptions{.min_edge_share = nan},
           ChoiceOptions{.ambiguous_margin = -1}, ChoiceOptions{.ambiguous_margin = nan},
           ChoiceOptions{.narrow_margin = 30},  // degrees
       }) {
    EXPECT_THROW(choose_regions(loops, 1, options), InputError);
  }
}

TEST(ChooseRegions, AnAmbiguousChoiceKeepsNoneAsTheLargest) {
  const std::vector<RegionAngles> loops = {loop(0, {10, 120}), loop(1, {130, 40}),
                                           loop(1, {90, 90.4})};
  const RegionChoice choice = choose_regions(loops, 2);
  EXPECT_EQ(choice.status, ChoiceStatus::ambiguous);
  EXPECT_TRUE(choice.kept_largest.is_none());
}

}  // namespace
}  // namespace cocoon
