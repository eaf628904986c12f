#include "update/regions/facet_cut.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"
#include "tests/update/plane_to_cut.h"

namespace cocoon {
namespace {

using Plane = testing::PlaneToCut;
constexpr std::size_t side = Plane::side;
constexpr double steps = Plane::steps;

// A wall with a door: the cut is the door, 3 wide, however far the walls reach.
TEST(FacetCut, ClosesAGapTheShortestWay) {
  Plane plane;
  for (std::size_t y = 0; y < side; ++y) {
    if (y >= 17 && y < 20) continue;
    for (const std::uint32_t half : {0U, 1U}) {
      plane.border[TriangleId(plane.at(20, y).value + half)] = 1;
    }
  }
  std::vector<FacetPull> pulls;
  for (std::size_t y = 0; y < side; ++y) {
    if (y >= 17 && y < 20) continue;
    pulls.push_back({plane.at(19, y), 1024});
    pulls.push_back({plane.at(21, y), -1024});
  }
  const TriangleSet cut = facet_cut(plane.model, plane.border, pulls, {steps});
  const std::vector<Halfedge> halfedges = halfedges_of_cut(plane.model, plane.border, cut);
  EXPECT_EQ(halfedges.size(), 3U);
  for (const Halfedge h : halfedges) {
    EXPECT_EQ(cut[TriangleId(triangle_of_halfedge(h))], 1);
    EXPECT_NEAR(plane.model.centroid(TriangleId(triangle_of_halfedge(h))).x, 20, 1);
  }
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    if (plane.border[t] != 0) {
      EXPECT_EQ(cut[t], 0);
      continue;
    }
    const double x = plane.model.centroid(t).x;
    if (x < 20 || x > 21) {
      EXPECT_EQ(cut[t], x < 20 ? 1 : 0);
    }
  }
}

// Wherever it is looked for at first, the cut is that of all facets.
TEST(FacetCut, IsTheSameForEveryFirstNeighborhood) {
  Random random(4);
  int cuts = 0;
  for (int round = 0; round < 40; ++round) {
    Plane plane;
    for (std::size_t i = 0; i < 6 * side; ++i) {
      plane.border[TriangleId(random.below(plane.mesh.triangles.size()))] = 1;
    }
    std::vector<FacetPull> pulls;
    TriangleSet pulled = plane.border;
    for (std::size_t i = 0; i < 4 + 10 * static_cast<std::size_t>(round); ++i) {
      const TriangleId t(random.below(plane.mesh.triangles.size()));
      if (pulled[t] != 0) continue;
      pulled[t] = 1;
      const bool left = plane.model.centroid(t).x + 8 * random.uniform() < 20;
      pulls.push_back({t, left ? 3000 : -3000});
    }
    const TriangleSet all =
        facet_cut(plane.model, plane.border, pulls, {steps}, {.first_steps = 1000});
    cuts += halfedges_of_cut(plane.model, plane.border, all).empty() ? 0 : 1;
    for (const std::size_t first : {std::size_t{1}, std::size_t{3}, std::size_t{8}}) {
      const TriangleSet cut =
          facet_cut(plane.model, plane.border, pulls, {steps}, {.first_steps = first});
      EXPECT_EQ(cut, all);
    }
  }
  EXPECT_GT(cuts, 20);
}

TEST(FacetCut, WithoutPullsNothingIsOnTheSourceSide) {
  const Plane plane;
  const TriangleSet cut = facet_cut(plane.model, plane.border, {}, {steps});
  EXPECT_TRUE(members(cut).empty());
  EXPECT_TRUE(halfedges_of_cut(plane.model, plane.border, cut).empty());
}

// Parts of a model may be so far away that sums of lengths are beyond all integers.
TEST(FacetCut, SidesMayBeOfAnyLength) {
  Plane plane;
  for (Point& p : plane.mesh.points) p = 1e30 * p;
  const ModelIndex model(plane.mesh);
  const std::int64_t longest = edge_in_steps(model, plane.at(1, 1), 0, {steps});
  EXPECT_EQ(longest, std::int64_t{1} << 40);
  const std::vector<FacetPull> pulls{{plane.at(3, 3), 4 * longest}, {plane.at(9, 9), -4 * longest}};
  const TriangleSet cut = facet_cut(model, plane.border, pulls, {steps});
  EXPECT_EQ(members(cut).size(), 1U);  // three sides cost less than the pull
}

// Anywhere between two lines of facets that pull, but for the dear ones.
TEST(FacetCut, RunsWhereFacetsAreNotDear) {
  const Plane plane;
  std::vector<FacetPull> pulls;
  for (std::size_t y = 0; y < side; ++y) {
    pulls.push_back({plane.at(10, y), std::int64_t{1} << 30});
    pulls.push_back({plane.at(30, y), -(std::int64_t{1} << 30)});
  }
  for (const double band : {14.0, 25.0}) {
    TriangleSet dear(plane.border.size(), 1);
    for (const TriangleId t : dear.ids()) {
      if (std::abs(plane.model.centroid(t).x - band) < 1.2) dear[t] = 0;
    }
    const TriangleSet cut = facet_cut(plane.model, plane.border, pulls, {steps, &dear, 3});
    const std::vector<Halfedge> halfedges = halfedges_of_cut(plane.model, plane.border, cut);
    EXPECT_GE(halfedges.size(), side);
    for (const Halfedge h : halfedges) EXPECT_EQ(dear[TriangleId(triangle_of_halfedge(h))], 0);
  }
}

}  // namespace
}  // namespace cocoon
