// Models of several parts: rim points that are nearest to another one than the others.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>

#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

// Points above a speck of dust look for the surface below it, as long as they are a tenth of all;
// or if more are allowed, as long as more points are elsewhere than there.
TEST(OverlappingFacets, ATenthOfTheRimMayBeNearestToAnotherPart) {
  TriangleMesh model = testing::grid_plane(20);
  for (Point& p : model.points) p = 2 * p;
  for (const Point& p : {Point{0, 0, 1}, Point{40, 0, 1}, Point{0, 40, 1}}) {
    model.points.push_back(p);
  }
  const std::size_t last = model.points.size() - 1;
  model.triangles.push_back({VertexId(last - 2), VertexId(last - 1), VertexId(last)});
  const auto on_speck = [&](std::size_t raised, std::size_t relocated,
                            const OverlapOptions& options = {}) {
    RimLoop loop = circle(40, {12, 12, 0}, 6);
    for (std::size_t i = 0; i < raised; ++i) loop.points[i].z = 1;
    const Overlap overlap = overlapping_facets(model, rim_of({loop}), options);
    EXPECT_EQ(overlap.figures.relocated, relocated);
    const auto& feet = overlap.loops[0].feet;
    return std::count_if(feet.begin(), feet.end(), [](const Point& foot) { return foot.z > 0.5; });
  };
  EXPECT_EQ(on_speck(4, 4), 0);
  EXPECT_EQ(on_speck(5, 0), 5);
  const OverlapOptions most_decide{.max_unmatched_share = 0.6};
  EXPECT_EQ(on_speck(16, 16, most_decide), 0);
  EXPECT_EQ(on_speck(20, 0, most_decide), 20);
  EXPECT_EQ(on_speck(24, 16, most_decide), 40);
}

// By either rule; it does not count as a point above a facet that faces away.
TEST(OverlappingFacets, APointNearestToAnotherPartIsLocatedOnThatOfTheOthers) {
  TriangleMesh model = testing::grid_plane(20);
  for (Point& p : model.points) p = 2 * p;
  const std::uint32_t first = static_cast<std::uint32_t>(model.points.size());
  for (const Point& p : {Point{17.6, 11.7, 1}, Point{18.5, 11.8, 1}, Point{18, 12.6, 1}}) {
    model.points.push_back(p);
  }
  model.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  RimLoop loop = circle(40, {12, 12, 0}, 6);
  loop.points[0].z = 1;
  for (const LocationRule rule : {LocationRule::closest_facet, LocationRule::nearest_vertex_star}) {
    const Overlap overlap = overlapping_facets(model, rim_of({loop}), {.rule = rule});
    EXPECT_EQ(overlap.figures.relocated, 1U);
    EXPECT_EQ(overlap.figures.facing_away, 0U);
    EXPECT_EQ(overlap.loops[0].feet[0].z, 0);
  }
}

}  // namespace
}  // namespace cocoon
