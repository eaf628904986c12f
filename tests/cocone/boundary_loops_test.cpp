#include "cocone/boundary_loops.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "cocone/orient_surface.h"
#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// A grid of columns x rows squares, two triangles each, without the squares that `is_hole` names.
template <class IsHole>
TriangleMesh grid(int columns, int rows, IsHole is_hole) {
  TriangleMesh mesh = gallery::open_patch(rows, columns);
  std::vector<Triangle> kept;
  for (const TriangleId t : mesh.triangles.ids()) {
    const int square = static_cast<int>(t.value / 2);
    if (!is_hole(square % columns, square / columns)) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = IdVector<TriangleId, Triangle>(kept);
  return mesh;
}

bool is_closed_walk(const BoundaryLoop& loop) {
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    if (loop.edges[i].to != loop.edges[(i + 1) % loop.edges.size()].from) return false;
  }
  return !loop.edges.empty();
}

const auto no_hole = [](int, int) { return false; };

TEST(BoundaryLoops, OneTriangle) {
  const TriangleMesh mesh = gallery::make_mesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  const BoundaryLoops result = boundary_loops(mesh);
  ASSERT_EQ(result.loops.size(), 1U);
  EXPECT_EQ(result.loops[0].edges.size(), 3U);
  EXPECT_DOUBLE_EQ(result.loops[0].perimeter, 12);
  EXPECT_TRUE(result.loops[0].pin_hole);
  EXPECT_EQ(result.loops[0].edges[0].from, VertexId(0));  // lexicographically first
  EXPECT_EQ(result.loops[0].edges[0].to, VertexId(1));    // in the triangle's direction
  EXPECT_DOUBLE_EQ(result.median_edge, 4);
}

TEST(BoundaryLoops, GridHasItsOutline) {
  const TriangleMesh mesh = grid(6, 5, no_hole);
  const BoundaryLoops result = boundary_loops(mesh);
  ASSERT_EQ(result.loops.size(), 1U);
  EXPECT_TRUE(is_closed_walk(result.loops[0]));
  EXPECT_EQ(result.loops[0].edges.size(), 22U);
  EXPECT_DOUBLE_EQ(result.loops[0].perimeter, 22);
  EXPECT_FALSE(result.loops[0].pin_hole);
  EXPECT_EQ(result.rims(), 1U);
  for (const BoundaryEdge& edge : result.loops[0].edges) {
    const Triangle& t = mesh.triangles[edge.triangle];
    EXPECT_NE(std::find(t.begin(), t.end(), edge.from), t.end());
    EXPECT_NE(std::find(t.begin(), t.end(), edge.to), t.end());
  }
}

TEST(BoundaryLoops, HolesAreLoopsAndSmallOnesPinHoles) {
  const TriangleMesh mesh = grid(20, 20, [](int x, int y) {
    return (x == 3 && y == 3) || (x >= 9 && x < 14 && y >= 9 && y < 14);
  });
  const BoundaryLoops result = boundary_loops(mesh);
  ASSERT_EQ(result.loops.size(), 3U);
  EXPECT_EQ(result.pin_holes, 1U);
  EXPECT_EQ(result.loops[0].edges.size(), 80U);
  EXPECT_EQ(result.loops[1].edges.size(), 4U);
  EXPECT_TRUE(result.loops[1].pin_hole);
  EXPECT_EQ(result.loops[2].edges.size(), 20U);
  for (const BoundaryLoop& loop : result.loops) EXPECT_TRUE(is_closed_walk(loop));
}

// Two square holes share the corner (2, 2): each of its two fans leads from one to the other.
TEST(BoundaryLoops, HolesThatTouchAtAVertexAreOneLoop) {
  const TriangleMesh mesh =
      grid(4, 4, [](int x, int y) { return (x == 1 && y == 1) || (x == 2 && y == 2); });
  const BoundaryLoops result = boundary_loops(mesh);
  ASSERT_EQ(result.loops.size(), 2U);
  for (const BoundaryLoop& loop : result.loops) EXPECT_TRUE(is_closed_walk(loop));
  EXPECT_EQ(result.loops[0].edges.size(), 16U);
  EXPECT_EQ(result.loops[1].edges.size(), 8U);
}

TEST(BoundaryLoops, OrientationOfTheInputDoesNotMatter) {
  TriangleMesh mesh = grid(6, 5, no_hole);
  const BoundaryLoops expected = boundary_loops(mesh);
  Random random(3);
  for (Triangle& t : mesh.triangles) {
    if (random.uniform() < 0.3) std::swap(t[1], t[2]);
  }
  const BoundaryLoops result = boundary_loops(mesh);
  ASSERT_EQ(result.loops.size(), 1U);
  EXPECT_TRUE(is_closed_walk(result.loops[0]));
  EXPECT_EQ(result.loops[0].edges[0].to, expected.loops[0].edges[0].to);
}

TEST(BoundaryLoops, SurplusTrianglesAreLeftOut) {
  // A fin stands on an inner edge of the grid: the flat pair stays.
  TriangleMesh mesh = grid(6, 5, no_hole);
  const VertexId top = mesh.points.push_back({1.5, 1, 1});
  mesh.triangles.push_back({VertexId(8), VertexId(9), top});
  const BoundaryLoops result = boundary_loops(mesh);
  EXPECT_EQ(result.surplus_triangles, 1U);
  ASSERT_EQ(result.loops.size(), 1U);
  EXPECT_EQ(result.loops[0].edges.size(), 22U);
}

TEST(BoundaryLoops, DebrisIsNotListed) {
  TriangleMesh mesh = grid(10, 10, no_hole);
  const VertexId a = mesh.points.push_back({50, 0, 0});
  const VertexId b = mesh.points.push_back({51, 0, 0});
  const VertexId c = mesh.points.push_back({50, 1, 0});
  mesh.triangles.push_back({a, b, c});
  const BoundaryLoops result = boundary_loops(mesh);
  EXPECT_EQ(result.loops.size(), 1U);
  EXPECT_EQ(result.small_components, 1U);
  EXPECT_EQ(result.discarded_loops, 1U);
  EXPECT_EQ(boundary_loops(mesh, {.min_component_share = 0}).loops.size(), 2U);
}

TEST(BoundaryLoops, MoebiusStripHasOneLoop) {
  const BoundaryLoops result = boundary_loops(gallery::moebius_strip(12));
  EXPECT_EQ(result.non_orientable, 1U);
  ASSERT_EQ(result.loops.size(), 1U);
  EXPECT_EQ(result.loops[0].edges.size(), 24U);
  EXPECT_TRUE(is_closed_walk(result.loops[0]));
}

// The triangles tell no direction: the same one in any numbering and orientation.
TEST(BoundaryLoops, OfAOneSidedPartRunTheSameWay) {
  const auto places = [](const TriangleMesh& mesh) {
    const BoundaryLoops found = boundary_loops(mesh);
    std::vector<Point> points;
    for (const BoundaryEdge& edge : found.loops.front().edges) {
      points.push_back(mesh.points[edge.from]);
    }
    return points;
  };
  const TriangleMesh strip = gallery::moebius_strip(12);
  const std::vector<Point> expected = places(strip);
  Random random(9);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::size_t> number(strip.points.size());
    std::iota(number.begin(), number.end(), std::size_t{0});
    for (std::size_t i = number.size(); i > 1; --i) {
      std::swap(number[i - 1], number[random.below(i)]);
    }
    TriangleMesh other{strip.points, strip.triangles};
    for (const VertexId v : strip.points.ids()) {
      other.points[VertexId(number[v.index()])] = strip.points[v];
    }
    for (Triangle& t : other.triangles) {
      for (VertexId& v : t) v = VertexId(number[v.index()]);
      if (random.uniform() < 0.5) std::swap(t[0], t[1]);
    }
    EXPECT_EQ(places(other), expected) << round;
  }
}

TEST(BoundaryLoops, ClosedAndEmptySurfacesHaveNone) {
  EXPECT_TRUE(boundary_loops(gallery::tetrahedron()).loops.empty());
  EXPECT_TRUE(boundary_loops(TriangleMesh{}).loops.empty());
}

// Also where squares of lengths leave the range of double.
TEST(BoundaryLoops, HaveLengthsAtAnyScale) {
  const TriangleMesh mesh = grid(9, 5, [](int x, int y) { return x == 4 && y == 2; });
  const BoundaryLoops loops = boundary_loops(mesh);
  ASSERT_EQ(loops.loops.size(), 2U);
  EXPECT_EQ(loops.pin_holes, 1U);
  for (const double scale : {0x1p+600, 0x1p-600}) {
    TriangleMesh scaled = mesh;
    for (Point& p : scaled.points) p = scale * p;
    const HalfedgeRings rings = link_halfedges(scaled);
    for (const BoundaryLoops& of_scaled :
         {boundary_loops(scaled), boundary_loops(scaled, rings, edge_components(scaled, rings))}) {
      EXPECT_EQ(of_scaled.median_edge, scale * loops.median_edge);
      EXPECT_EQ(of_scaled.pin_holes, loops.pin_holes);
      ASSERT_EQ(of_scaled.loops.size(), loops.loops.size());
      for (std::size_t l = 0; l < loops.loops.size(); ++l) {
        EXPECT_EQ(of_scaled.loops[l].perimeter, scale * loops.loops[l].perimeter);
        EXPECT_EQ(of_scaled.loops[l].pin_hole, loops.loops[l].pin_hole);
      }
    }
  }
}

TEST(BoundaryLoops, PatchHasOneRim) {
  for (const double rho : {0.13, 0.3, 0.5}) {
    ReconstructOptions options = open_cloud_defaults();
    options.boundary.rho = rho;
    const ReconstructResult open = reconstruct_cocone(shapes::dome_patch(30, 0.3, 4), options);
    const BoundaryLoops result = boundary_loops(open.mesh);
    EXPECT_EQ(result.rims(), 1U) << rho;
    EXPECT_EQ(result.pin_holes, 0U) << rho;
    EXPECT_EQ(mesh_check(open.mesh).euler, 1) << rho;
  }
}

}  // namespace
}  // namespace cocoon
