#include "update/model/euler_number.h"

#include <gtest/gtest.h>

#include "geom/mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

std::ptrdiff_t euler_number_of(const ModelIndex& model) {
  return euler_number(model, irregular_sides(model));
}

// Twelve triangles with corners of their own have 36 for the 8 of a cube; what no triangle uses is
// no vertex.
TEST(RepeatedVertices, AreThoseOfTrianglesAtOnePlace) {
  TriangleMesh mesh = gallery::unshared(gallery::cube());
  mesh.points.push_back(mesh.points[VertexId(0U)]);
  EXPECT_EQ(repeated_vertices(ModelIndex(mesh)), 36U - 8U);
  const TriangleMesh cube = gallery::cube();
  EXPECT_EQ(repeated_vertices(ModelIndex(cube)), 0U);
}

// Closed, open, one-sided, in parts, with vertices that no triangle uses.
TEST(EulerNumber, IsThatOfTheCheck) {
  TriangleMesh with_unused = gallery::open_patch(4, 5);
  with_unused.points.push_back({9, 9, 9});
  TriangleMesh holed = gallery::torus(12, 8);
  holed.triangles.resize(holed.triangles.size() - 1);
  for (const TriangleMesh& mesh :
       {gallery::cube(), gallery::torus(12, 8), gallery::open_patch(4, 5), with_unused, holed,
        gallery::moebius_strip(7), gallery::projective_plane(),
        gallery::two_tetrahedra_sharing_a_vertex(),
        gallery::join(gallery::cube(), gallery::torus(12, 8))}) {
    EXPECT_EQ(euler_number_of(ModelIndex(mesh)), mesh_check(mesh).euler);
  }
  const TriangleMesh cube = gallery::cube();
  EXPECT_EQ(euler_number_of(ModelIndex::of_smooth(cube)), 2);
  EXPECT_EQ(euler_number(cube.points.size(), cube.triangles.size()), 2);
}

// Two sheets that touch along an edge have it twice.
TEST(EulerNumber, CountsAnEdgeForEachTwoTriangles) {
  const TriangleMesh mesh = gallery::two_tetrahedra_sharing_an_edge();
  EXPECT_EQ(mesh_check(mesh).euler, 3);
  EXPECT_EQ(euler_number_of(ModelIndex(mesh)), 2);
  EXPECT_EQ(euler_number_of(ModelIndex(gallery::unshared(gallery::cube()))), 8 - 36 + 12);
}

}  // namespace
}  // namespace cocoon
