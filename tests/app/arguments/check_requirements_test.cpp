#include "app/arguments/check_requirements.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/triangle_mesh.h"

namespace cocoon::app {
namespace {

// The triangles at the edge from (0, 0, 0) to (0, 0, 1), each with a corner of its own, and whether
// they run along it upward.
TriangleMesh fan(const std::vector<bool>& upward) {
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(std::vector<Point>{{0, 0, 0}, {0, 0, 1}});
  double x = 1;
  for (const bool up : upward) {
    const VertexId tip(mesh.points.size());
    mesh.points.push_back({x, 1, 0.5});
    x += 1;
    const VertexId low(0);
    const VertexId high(1);
    mesh.triangles.push_back(up ? Triangle{low, high, tip} : Triangle{high, low, tip});
  }
  return mesh;
}

std::string failure(const char* word, const TriangleMesh& mesh,
                    std::size_t repeated_vertex_faces = 0) {
  Certificate certificate{mesh_check(mesh), repeated_vertex_faces, 0, {}};
  if (needs_self_intersections({word})) certificate.self_intersections = self_intersection(mesh);
  const std::vector<std::string> failures = failed_requirements({word}, certificate, mesh);
  return failures.empty() ? "" : failures[0];
}

TEST(CheckRequirements, ClosedCountsWhatLeavesAMeshOpen) {
  EXPECT_EQ(
      failure("closed", fan({true, false})),
      "not closed (4 open edges, 0 others with an odd number of triangles, as near (0, 0, 0))");
  EXPECT_EQ(
      failure("closed", fan({true, false, true})),
      "not closed (6 open edges, 1 other with an odd number of triangles, as near (0, 0, 0))");
  EXPECT_EQ(
      failure("watertight", fan({true, false, true, false})),
      "not watertight (8 open edges, 0 others with an odd number of triangles, as near (0, 0, 0))");
}

// Two tetrahedra on both sides of a triangle that is there once; then two more with an edge in
// common, which has four triangles and leaves nothing open.
TEST(CheckRequirements, ClosedTellsOnlyOfOddEdges) {
  const auto v = [](std::size_t i) { return VertexId(i); };
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(
      std::vector<Point>{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}, {5, 0, -1}});
  mesh.triangles.push_back({v(0), v(1), v(2)});
  const auto add_tent = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t tip) {
    mesh.triangles.push_back({v(a), v(b), v(tip)});
    mesh.triangles.push_back({v(b), v(c), v(tip)});
    mesh.triangles.push_back({v(c), v(a), v(tip)});
  };
  add_tent(0, 1, 2, 3);
  add_tent(0, 1, 2, 4);
  EXPECT_EQ(failure("closed", mesh),
            "not closed (0 open edges, 3 others with an odd number of triangles, as near "
            "(5, 0, 0))");
  for (const Point& p : {Point{0, 0, 0}, Point{0, 0, 1}, Point{1, 0, 0}, Point{0, 1, 0},
                         Point{-1, 0, 0}, Point{0, -1, 0}}) {
    mesh.points.push_back(p);
  }
  for (const std::size_t at : {7U, 9U}) {
    mesh.triangles.push_back({v(5), v(6), v(at)});
    add_tent(5, 6, at, at + 1);
  }
  EXPECT_EQ(failure("closed", mesh),
            "not closed (0 open edges, 3 others with an odd number of triangles)");
}

TEST(CheckRequirements, OrientedDoesNotCountOpenEdges) {
  EXPECT_EQ(failure("oriented", fan({true, false})), "");
  EXPECT_EQ(failure("oriented", fan({true, true})),
            "not oriented (1 edge with two triangles in the same direction, as near (0, 0, 0))");
  EXPECT_EQ(failure("oriented", fan({true, true, false})),
            "not oriented (edges with more than two triangles are not run through equally often "
            "both ways)");
}

TEST(CheckRequirements, ManifoldTellsWhere) {
  EXPECT_EQ(failure("manifold", fan({true, false})), "");
  EXPECT_EQ(failure("manifold", fan({true, false, true})),
            "not manifold (1 edge with more than two triangles, 2 pinched vertices, as near "
            "(0, 0, 0))");
  TriangleMesh pinched = fan({true});
  pinched.points.push_back({5, 5, 5});
  pinched.points.push_back({5, 6, 5});
  pinched.triangles.push_back({VertexId(1), VertexId(3), VertexId(4)});
  EXPECT_EQ(failure("manifold", pinched),
            "not manifold (0 edges with more than two triangles, 1 pinched vertex, as near "
            "(0, 0, 1))");
  EXPECT_EQ(failure("edge-manifold", pinched), "");
  EXPECT_EQ(failure("vertex-manifold", pinched),
            "not vertex-manifold (1 pinched vertex, as near (0, 0, 1))");
  EXPECT_EQ(failure("edge-manifold", fan({true, false, true})),
            "not edge-manifold (1 edge with more than two triangles, as near (0, 0, 0))");
}

TEST(CheckRequirements, PartsAndUnusedVerticesAreCounted) {
  TriangleMesh mesh = fan({true});
  EXPECT_EQ(failure("connected", mesh), "");
  EXPECT_EQ(failure("orientable", mesh), "");
  EXPECT_EQ(failure("no-unused-vertices", mesh), "");
  const auto count = static_cast<std::uint32_t>(mesh.points.size());
  for (int k = 0; k < 4; ++k) mesh.points.push_back({9, 9 + 0.5 * k, 0.25 * k * k});
  EXPECT_EQ(failure("no-unused-vertices", mesh),
            "fails no-unused-vertices (4 vertices without a triangle)");
  mesh.triangles.push_back({VertexId(count), VertexId(count + 1), VertexId(count + 2)});
  EXPECT_EQ(failure("no-unused-vertices", mesh),
            "fails no-unused-vertices (1 vertex without a triangle)");
  EXPECT_EQ(failure("connected", mesh), "not connected (2 components)");
}

// Also those that no mesh of ours has any more, since the reader left them out.
TEST(CheckRequirements, BadTrianglesOfTheFileCount) {
  EXPECT_EQ(failure("no-bad-triangles", fan({true})), "");
  EXPECT_EQ(failure("no-bad-triangles", fan({true}), 2),
            "fails no-bad-triangles (triangles: 2 with a repeated vertex, 0 without area, 0 "
            "repeated, 0 with fewer corners)");
  TriangleMesh twice = fan({true});
  twice.triangles.push_back(twice.triangles[TriangleId(0)]);
  EXPECT_EQ(failure("no-bad-triangles", twice),
            "fails no-bad-triangles (triangles: 0 with a repeated vertex, 0 without area, 1 "
            "repeated, 0 with fewer corners, as near (0, 0, 0))");
}

TEST(CheckRequirements, CrossingTrianglesHaveAPlace) {
  TriangleMesh crossing = fan({true});
  for (const Point& p : {Point{0.5, 0.5, 0.4}, Point{0.5, 0.5, 3}, Point{0.6, -4, 0.4}}) {
    crossing.points.push_back(p);
  }
  crossing.triangles.push_back({VertexId(3), VertexId(4), VertexId(5)});
  EXPECT_EQ(failure("no-self-intersections", crossing),
            "fails no-self-intersections (1 pair of triangles crosses, as near (0, 0, 0))");
}

}  // namespace
}  // namespace cocoon::app
