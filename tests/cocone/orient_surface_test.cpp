#include "cocone/orient_surface.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <utility>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TEST(OrientSurface, MajorityDecides) {
  TriangleMesh mesh = gallery::open_patch(5, 5);
  const TriangleMesh expected = mesh;
  std::swap(mesh.triangles[TriangleId(7)][1], mesh.triangles[TriangleId(7)][2]);
  const OrientationReport report = orient_surface(mesh);
  EXPECT_EQ(report.flipped, 1U);
  EXPECT_EQ(mesh, expected);
}

// As many triangles run one way as the other: that of the smallest triangle is taken.
TEST(OrientSurface, InATieTheSmallestTriangleDecides) {
  const TriangleMesh expected = gallery::open_patch(5, 5);
  const std::size_t half = expected.triangles.size() / 2;
  for (const bool first_half : {false, true}) {
    TriangleMesh mesh = expected;
    for (const TriangleId t : mesh.triangles.ids()) {
      if ((t.index() < half) == first_half) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    const Triangle before = mesh.triangles[TriangleId(0)];
    EXPECT_EQ(orient_surface(mesh).flipped, half);
    EXPECT_EQ(mesh.triangles[TriangleId(0)], before);
  }
}

// A Moebius strip stays as it is; a part beside it is turned all the same.
TEST(OrientSurface, OneSidedPartsStayAsTheyAre) {
  TriangleMesh mesh = gallery::open_patch(5, 5);
  std::swap(mesh.triangles[TriangleId(7)][1], mesh.triangles[TriangleId(7)][2]);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (std::uint32_t k = 0; k < 5; ++k) mesh.points.push_back({10.0 + k, k % 2 * 1.0, k * k * 0.1});
  for (std::uint32_t k = 0; k < 5; ++k) {
    mesh.triangles.push_back(
        {VertexId(first + k), VertexId(first + (k + 1) % 5), VertexId(first + (k + 2) % 5)});
  }
  const TriangleMesh before = mesh;
  const OrientationReport report = orient_surface(mesh);
  EXPECT_EQ(report.non_orientable, 1U);
  EXPECT_EQ(report.flipped, 1U);
  for (std::size_t t = 50; t < mesh.triangles.size(); ++t) {
    EXPECT_EQ(mesh.triangles[TriangleId(t)], before.triangles[TriangleId(t)]);
  }
}

}  // namespace
}  // namespace cocoon
