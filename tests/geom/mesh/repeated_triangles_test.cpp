#include "geom/mesh/repeated_triangles.h"

#include <gtest/gtest.h>

#include "geom/mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

std::size_t leave_out(TriangleMesh& mesh) {
  return leave_out_repeated_triangles(mesh, repeated_points(mesh.points.span()), {2});
}

TEST(RepeatedTriangles, SingleOnesGo) {
  const TriangleMesh cube = gallery::cube();
  for (const bool turn : {false, true}) {
    TriangleMesh mesh = cube;
    for (const std::size_t t : {3U, 7U, 7U}) {
      auto [a, b, c] = cube.triangles[TriangleId(t)];
      mesh.triangles.push_back(turn ? Triangle{a, c, b} : Triangle{c, a, b});
    }
    EXPECT_EQ(leave_out(mesh), 3U);
    EXPECT_EQ(mesh, cube);
  }
}

TEST(RepeatedTriangles, OnesThatStandAloneAtThePlaceOfOthersGo) {
  const TriangleMesh cube = gallery::cube();
  TriangleMesh alone;
  for (const Point& p : corners_of(cube, TriangleId(5U))) alone.points.push_back(p);
  alone.triangles.push_back({VertexId(0U), VertexId(1U), VertexId(2U)});
  TriangleMesh mesh = gallery::join(cube, alone);
  EXPECT_EQ(leave_out(mesh), 1U);
  EXPECT_EQ(mesh.triangles, cube.triangles);
  // Where it comes first in the file, the surface is kept all the same.
  mesh = gallery::join(alone, cube);
  EXPECT_EQ(leave_out(mesh), 0U);
  EXPECT_EQ(mesh.triangles.size(), 13U);
}

TEST(RepeatedTriangles, WholeBodiesAndBothSidesOfSheetsGo) {
  const TriangleMesh cube = gallery::cube();
  for (const TriangleMesh& again : {cube, gallery::flipped(cube)}) {
    TriangleMesh mesh = gallery::join(gallery::join(cube, again), again);
    EXPECT_EQ(leave_out(mesh), 24U);
    EXPECT_EQ(mesh.triangles, cube.triangles);
    mesh = cube;  // with the same vertices
    for (const Triangle& t : again.triangles) mesh.triangles.push_back(t);
    EXPECT_EQ(leave_out(mesh), 12U);
    EXPECT_EQ(mesh, cube);
  }
}

TEST(RepeatedTriangles, WallsThatBodiesHaveInCommonStay) {
  // The second tetrahedron is the mirror image of the first behind their common face.
  const TriangleMesh one = gallery::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  TriangleMesh other = gallery::flipped(one);
  other.points[VertexId(3U)] = {0, 0, -1};
  const TriangleMesh mesh = gallery::join(one, other);
  TriangleMesh left = mesh;
  EXPECT_EQ(leave_out(left), 0U);
  EXPECT_EQ(left, mesh);
}

// A fin without thickness on a closed body: two sheets that are sides of one another.
TEST(RepeatedTriangles, FinsWithoutThicknessStay) {
  TriangleMesh mesh = gallery::cube();
  const auto [a, b, c] = mesh.triangles[TriangleId(0U)];
  const VertexId tip = mesh.points.push_back({0.5, 0.5, 9});
  mesh.triangles.push_back({a, b, tip});
  mesh.triangles.push_back({b, a, tip});
  const TriangleMesh before = mesh;
  EXPECT_EQ(leave_out(mesh), 0U);
  EXPECT_EQ(mesh, before);
}

TEST(RepeatedTriangles, OthersAreLeftAsTheyAre) {
  TriangleMesh mesh = gallery::cube();
  EXPECT_EQ(leave_out(mesh), 0U);
  EXPECT_EQ(mesh, gallery::cube());
  TriangleMesh none;
  EXPECT_EQ(leave_out(none), 0U);
}

}  // namespace
}  // namespace cocoon
