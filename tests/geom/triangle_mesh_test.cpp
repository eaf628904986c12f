#include "geom/triangle_mesh.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

Triangle triangle(int a, int b, int c) { return {VertexId(a), VertexId(b), VertexId(c)}; }

TEST(TriangleMesh, RepeatedVertices) {
  EXPECT_FALSE(repeats_a_vertex(triangle(4, 2, 3)));
  EXPECT_TRUE(repeats_a_vertex(triangle(4, 4, 3)));
  EXPECT_TRUE(repeats_a_vertex(triangle(3, 4, 4)));
  EXPECT_TRUE(repeats_a_vertex(triangle(4, 3, 4)));
}

TEST(TriangleMesh, SmallestCornerIsTheFirstOfEqualOnes) {
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 3; ++c) {
        const Triangle t = triangle(a, b, c);
        EXPECT_EQ(smallest_corner(t),
                  static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin()));
      }
    }
  }
}

TEST(TriangleMesh, CornersInOrder) {
  const TriangleMesh mesh = gallery::make_mesh({{3, 0, 0}, {0, 4, 0}, {0, 0, 0}}, {{0, 1, 2}});
  const auto corners = corners_of(mesh, TriangleId(0));
  EXPECT_EQ(corners, (std::array<Point, 3>{{{3, 0, 0}, {0, 4, 0}, {0, 0, 0}}}));
  EXPECT_EQ(finite_corners_of(mesh, TriangleId(0)), corners);
  EXPECT_EQ(sorted_corners(corners), (std::array<Point, 3>{{{0, 0, 0}, {0, 4, 0}, {3, 0, 0}}}));
  EXPECT_EQ(corners_from_smallest(corners),
            (std::array<Point, 3>{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}));
  EXPECT_EQ(edge_length(mesh, TriangleId(0), 0), 4);
  EXPECT_EQ(edge_length(mesh, TriangleId(0), 1), 3);
  EXPECT_EQ(edge_length(mesh, TriangleId(0), 2), 5);
  EXPECT_EQ(longest_edge(mesh, TriangleId(0)), 5);
  EXPECT_EQ(shortest_edge(mesh, TriangleId(0)), 3);
}

TEST(TriangleMesh, MissingAndNonFiniteVerticesAreRefused) {
  TriangleMesh mesh = gallery::cube();
  EXPECT_NO_THROW(require_valid_triangles(mesh));
  EXPECT_NO_THROW(require_valid_triangles(TriangleMesh{}));
  mesh.points[mesh.triangles[TriangleId(1)][2]].y = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(require_valid_triangles(mesh));
  EXPECT_THROW(finite_corners_of(mesh, TriangleId(1)), InputError);
  for (const VertexId missing : {VertexId(8), VertexId()}) {
    mesh.triangles[TriangleId(5)][1] = missing;
    EXPECT_NO_THROW(require_valid_triangle(mesh, TriangleId(4)));
    EXPECT_THROW(require_valid_triangle(mesh, TriangleId(5)), InputError);
    EXPECT_THROW(require_valid_triangles(mesh), InputError);
    EXPECT_THROW(finite_corners_of(mesh, TriangleId(5)), InputError);
  }
}

TEST(TriangleMesh, EqualSurfacesBecomeEqualArrays) {
  TriangleMesh mesh = gallery::torus(9, 7);
  canonicalize_triangles(mesh);
  EXPECT_TRUE(std::is_sorted(mesh.triangles.begin(), mesh.triangles.end()));
  TriangleMesh turned = mesh;
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  for (Triangle& t : turned.triangles) {
    EXPECT_EQ(smallest_corner(t), 0U);
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  EXPECT_NE(turned, mesh);
  canonicalize_triangles(turned, {3});
  EXPECT_EQ(turned, mesh);
}

}  // namespace
}  // namespace cocoon
