#include "cocone/checks/surface_roughness.h"

#include <cstddef>
#include <gtest/gtest.h>

#include "cocone/reconstruct.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

SurfaceRoughness roughness(const TriangleMesh& mesh, std::size_t unused = 0) {
  return surface_roughness(mesh, mesh.points.size() + unused);
}

void expect_roughness(const TriangleMesh& mesh, std::size_t parts, std::ptrdiff_t twice_handles) {
  const SurfaceRoughness found = roughness(mesh);
  EXPECT_EQ(found.parts, parts);
  EXPECT_EQ(found.twice_handles, twice_handles);
  EXPECT_EQ(found.unused_vertices, 0U);
}

TEST(SurfaceRoughness, CountsPartsAndTwiceTheHandles) {
  const TriangleMesh ball = reconstruct_tight(shapes::sphere(300, 1)).mesh;
  const TriangleMesh ring = reconstruct_tight(shapes::random_torus(1500, 0.4, 1)).mesh;
  expect_roughness(ball, 1, 0);
  expect_roughness(ring, 1, 2);
  expect_roughness(gallery::join(ball, ring), 2, 2);
  EXPECT_EQ(roughness(ball, 7).unused_vertices, 7U);
}

TEST(SurfaceRoughness, CountsWhereTheSurfaceTouchesItself) {
  expect_roughness(gallery::two_tetrahedra_sharing_an_edge(), 2, 2);
  expect_roughness(gallery::two_tetrahedra_sharing_a_vertex(), 2, 1);
}

TEST(SurfaceRoughness, IsComparedInEachNumber) {
  const SurfaceRoughness one{2, 4, 5};
  const auto is_at_most = [&](const SurfaceRoughness& other) { return one.is_at_most(other, 3); };
  EXPECT_TRUE(is_at_most({2, 4, 5}));
  EXPECT_TRUE(is_at_most({3, 6, 6}));
  EXPECT_FALSE(is_at_most({1, 9, 9}));
  EXPECT_FALSE(is_at_most({9, 2, 9}));
  EXPECT_FALSE(is_at_most({2, 4, 4}));
  EXPECT_FALSE(is_at_most({2, 5, 4}));
}

// A few unused vertices are worth a part less, but not a body, nor all of the surface.
TEST(SurfaceRoughness, APartLessIsWorthSomeVertices) {
  const SurfaceRoughness two{2, 0, 5};
  EXPECT_TRUE((SurfaceRoughness{1, 0, 8}).is_at_most(two, 3));
  EXPECT_FALSE((SurfaceRoughness{1, 0, 9}).is_at_most(two, 3));
  EXPECT_FALSE((SurfaceRoughness{0, 0, 5}).is_at_most(two, 3));
  EXPECT_TRUE((SurfaceRoughness{0, 0, 5}).is_at_most({0, 0, 5}, 3));
}

}  // namespace
}  // namespace cocoon
