#include "update/cloud/raised_loops.h"

#include <gtest/gtest.h>

#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

// A scan of the plane, and beside it another part of its surface with an outline and a hole.
struct Parts {
  TriangleMesh model = testing::grid_plane(40);
  RimLoop scan = circle(60, {12, 20, 0}, 10);
  RimLoop outline = circle(30, {31, 20, 0}, 5);
  RimLoop hole = circle(20, {31, 20, 0}, 3);

  Parts() { outline.component = hole.component = 1; }

  Overlap overlap(const OverlapOptions& options = {}) const {
    return overlapping_facets(model, rim_of({scan, outline, hole}), options);
  }
};

// Part of its way, as where it climbs over something new, the outline of another part may be off
// the model; as a whole, as that of the floor of a pocket, it is not on it.
TEST(RaisedLoops, OutlinesAreComparedWithTheLongestLoop) {
  const auto match = [](std::size_t raised, const OverlapOptions& options = {}) {
    Parts parts;
    for (std::size_t i = 0; i < raised; ++i) parts.outline.points[i].z = -2;
    const Overlap overlap = parts.overlap(options);
    EXPECT_FALSE(overlap.loops[2].is_outline);
    EXPECT_TRUE(overlap.loops[1].is_outline);
    EXPECT_EQ(overlap.loops[1].raised, options.raised_distance < 2 ? raised : 0);
    EXPECT_EQ(overlap.loops[0].match, LoopMatch::on_model);
    return overlap.loops[1].match;
  };
  EXPECT_EQ(match(0), LoopMatch::on_model);
  EXPECT_EQ(match(21), LoopMatch::on_model);
  EXPECT_EQ(match(22), LoopMatch::off_model);
  EXPECT_EQ(match(30), LoopMatch::off_model);
  EXPECT_EQ(match(30, {.max_raised_outline = 1}), LoopMatch::on_model);
  EXPECT_EQ(match(30, {.raised_distance = 3}), LoopMatch::on_model);
  EXPECT_EQ(match(10, {.max_raised_outline = 0.3}), LoopMatch::off_model);
}

// Holes in a floor lie no better on the model than the floor does.
TEST(RaisedLoops, SoAreHolesInThem) {
  Parts parts;
  for (RimLoop* loop : {&parts.outline, &parts.hole}) {
    for (Point& p : loop->points) p.z = -2;
  }
  EXPECT_EQ(parts.overlap().loops[2].match, LoopMatch::off_model);
  // Unless all of the scan is as far off, or there is nothing else.
  for (Point& p : parts.scan.points) p.z = -2;
  EXPECT_EQ(parts.overlap().loops[2].match, LoopMatch::on_model);
  EXPECT_EQ(parts.overlap().loops[1].match, LoopMatch::on_model);
  const Overlap alone = overlapping_facets(parts.model, rim_of({parts.outline, parts.hole}));
  EXPECT_EQ(alone.loops[0].match, LoopMatch::on_model);
  EXPECT_EQ(alone.loops[1].match, LoopMatch::on_model);
}

// Distances are in spacings of the model where those are larger than the rim's.
TEST(RaisedLoops, InLargerSpacings) {
  TriangleMesh mesh = testing::grid_plane(4);
  for (Point& p : mesh.points) p = 10 * p;
  const ModelIndex model(mesh);
  CloudRim rim = rim_of({circle(60, {20, 20, 0}, 10)});
  EXPECT_EQ(larger_spacing(model, rim, TriangleId(0)), 10);
  rim.spacing = 12;
  EXPECT_EQ(larger_spacing(model, rim, TriangleId(0)), 12);

  rim.loops[0].points[7].z = 5;
  Overlap overlap = overlapping_facets(model, rim);
  EXPECT_NEAR(overlap.figures.largest_excess, 5.0 / 12, 1e-12);
  rim.loops.clear();
  overlap = {};
  count_raised(model, rim, 1, overlap);  // nothing to be counted
  EXPECT_TRUE(overlap.loops.empty());
}

}  // namespace
}  // namespace cocoon
