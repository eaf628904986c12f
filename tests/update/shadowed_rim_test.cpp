#include "update/shadowed_rim.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

// A circle over a plane, of which some points are far above it.
class ClimbingRim {
 public:
  explicit ClimbingRim(std::size_t far, double height = 0)
      : rim(rim_of({circle(40, {10, 10, height}, 6)})) {
    for (std::size_t i = 0; i < far; ++i) rim.loops[0].points[i].z += 10;
    overlap = overlapping_facets(testing::grid_plane(20), rim);
  }
  bool is_taken(const ShadowOptions& options = {}) {
    return take_shadowed_rim(rim, options, overlap);
  }

  CloudRim rim;
  Overlap overlap;
};

TEST(ShadowedRim, IsTakenIfHalfOfItLiesOnTheModel) {
  ClimbingRim half(20);
  EXPECT_EQ(half.overlap.status, OverlapStatus::no_overlap);
  EXPECT_TRUE(half.is_taken());
  EXPECT_EQ(half.overlap.status, OverlapStatus::ok);
  EXPECT_EQ(half.overlap.loops[0].match, LoopMatch::on_model);
  EXPECT_TRUE(half.overlap.leaves_model);
  EXPECT_EQ(half.overlap.figures.in_shadow, 20U);
  EXPECT_EQ(half.overlap.figures.in_shadow_of, 40U);
  ClimbingRim more(21);
  EXPECT_FALSE(more.is_taken());
  EXPECT_EQ(more.overlap.status, OverlapStatus::no_overlap);
  EXPECT_FALSE(more.overlap.leaves_model);
  EXPECT_TRUE(more.is_taken({.max_unmatched_share = 0.6}));
  EXPECT_FALSE(ClimbingRim(20).is_taken({.max_unmatched_share = 0}));
}

// Its spacing is 0.94.
TEST(ShadowedRim, TheOtherPointsAreClose) {
  EXPECT_TRUE(ClimbingRim(15, 0.46).is_taken());
  EXPECT_FALSE(ClimbingRim(15, 0.48).is_taken());
  EXPECT_TRUE(ClimbingRim(15, 0.48).is_taken({.max_distance = 0.52}));
}

TEST(ShadowedRim, OneThatLiesOnTheModelIsLeftAsItIs) {
  ClimbingRim rim(4);
  EXPECT_EQ(rim.overlap.status, OverlapStatus::ok);
  EXPECT_FALSE(rim.is_taken());
  EXPECT_EQ(rim.overlap.figures.in_shadow, 0U);
}

// Another loop is a hole in the cloud, as it is elsewhere.
TEST(ShadowedRim, IsThatOfTheLongestLoop) {
  CloudRim rim = rim_of({circle(40, {10, 10, 0}, 6), circle(20, {10, 10, 0}, 3)});
  for (RimLoop& loop : rim.loops) {
    for (std::size_t i = 0; i < 8; ++i) loop.points[i].z = 10;
  }
  Overlap overlap = overlapping_facets(testing::grid_plane(20), rim);
  EXPECT_TRUE(take_shadowed_rim(rim, {}, overlap));
  EXPECT_EQ(overlap.loops[0].match, LoopMatch::on_model);
  EXPECT_EQ(overlap.loops[1].match, LoopMatch::off_model);
}

// Points with cloud beyond them say nothing.
TEST(ShadowedRim, InnerPointsDoNotCount) {
  ClimbingRim rim(25);
  rim.rim.loops[0].inner.assign(40, 0);
  for (std::size_t i = 0; i < 20; ++i) rim.rim.loops[0].inner[i] = 1;
  rim.overlap = overlapping_facets(testing::grid_plane(20), rim.rim);
  EXPECT_EQ(rim.overlap.status, OverlapStatus::no_overlap);
  EXPECT_TRUE(rim.is_taken());
}

// Nor do those that other clouds cover; and what was taken stays on the model when that is asked.
TEST(ShadowedRim, CoveredPointsDoNotCount) {
  ClimbingRim rim(20);
  const std::vector<CloudRim> rims = {rim.rim, rim.rim};
  std::vector<std::vector<Point>> clouds = {{{100, 100, 100}}, {}};
  for (std::size_t i = 0; i < 15; ++i) clouds[1].push_back(rim.rim.loops[0].points[i]);
  std::vector<Overlap> overlaps(2, rim.overlap);
  excuse_covered_points(rims, clouds, overlaps, {.max_distance = 0.1});
  ASSERT_EQ(overlaps[0].loops[0].covered, 15U);
  EXPECT_EQ(overlaps[0].status, OverlapStatus::no_overlap);
  EXPECT_FALSE(take_shadowed_rim(rim.rim, {.max_unmatched_share = 0.19}, overlaps[0]));
  EXPECT_TRUE(take_shadowed_rim(rim.rim, {.max_unmatched_share = 0.2}, overlaps[0]));
  EXPECT_EQ(overlaps[0].figures.in_shadow, 5U);
  EXPECT_EQ(overlaps[0].figures.in_shadow_of, 25U);
  excuse_covered_points(rims, clouds, overlaps, {.max_distance = 0.1});
  EXPECT_EQ(overlaps[0].status, OverlapStatus::ok);
  EXPECT_EQ(overlaps[0].loops[0].match, LoopMatch::on_model);
}

TEST(ShadowedRim, RefusesTheOverlapOfAnother) {
  ClimbingRim rim(10);
  rim.overlap.loops.clear();
  EXPECT_THROW(rim.is_taken(), InputError);
  EXPECT_FALSE(take_shadowed_rim({}, {}, rim.overlap));
}

}  // namespace
}  // namespace cocoon
