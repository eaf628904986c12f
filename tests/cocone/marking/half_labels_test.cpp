#include "cocone/marking/half_labels.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

constexpr CellLabel out = CellLabel::out;
constexpr CellLabel in = CellLabel::in;

void expect_labels(const LabelCount& first, const LabelCount& second, CellLabel of_first,
                   CellLabel of_second, bool conflict) {
  for (const bool swapped : {false, true}) {
    const HalfLabels labels = swapped ? label_halves(second, first) : label_halves(first, second);
    EXPECT_EQ(swapped ? labels.second : labels.first, of_first);
    EXPECT_EQ(swapped ? labels.first : labels.second, of_second);
    EXPECT_EQ(labels.conflict, conflict);
  }
}

TEST(HalfLabels, AHalfWithoutLabelsIsOnTheOtherSide) {
  expect_labels({.out = 2, .in = 0}, {}, out, in, false);
  expect_labels({.out = 0, .in = 1}, {}, in, out, false);
  expect_labels({.out = 3, .in = 0}, {.out = 0, .in = 1}, out, in, false);
}

TEST(HalfLabels, TheMajorityCountsAndATieIsOut) {
  expect_labels({.out = 1, .in = 2}, {}, in, out, true);
  expect_labels({.out = 2, .in = 2}, {}, out, in, true);
  expect_labels({.out = 2, .in = 1}, {.out = 0, .in = 4}, out, in, true);
}

TEST(HalfLabels, TwoHalvesOnOneSideAreAConflict) {
  expect_labels({.out = 1, .in = 0}, {.out = 5, .in = 0}, out, out, true);
  expect_labels({.out = 0, .in = 1}, {.out = 1, .in = 2}, in, in, true);
}

}  // namespace
}  // namespace cocoon
