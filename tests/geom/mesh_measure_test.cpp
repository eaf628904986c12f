#include "geom/mesh_measure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TEST(MeshMeasure, Cube) {
  const MeshMeasure m = mesh_measure(gallery::cube(2));
  EXPECT_EQ(m.area, 24);
  EXPECT_EQ(m.signed_volume, 8);
  EXPECT_EQ(m.box, (Box{{0, 0, 0}, {2, 2, 2}}));
  EXPECT_EQ(m.edge_lengths.count, 18U);
  EXPECT_EQ(m.edge_lengths.min, 2);
  EXPECT_EQ(m.edge_lengths.median, 2);
  EXPECT_EQ(m.edge_lengths.max, std::sqrt(8.0));
  EXPECT_NEAR(m.edge_lengths.mean, (12 * 2 + 6 * std::sqrt(8.0)) / 18, 1e-15);
}

TEST(MeshMeasure, TetrahedronAndItsMirrorImage) {
  const MeshMeasure m = mesh_measure(gallery::tetrahedron());
  EXPECT_NEAR(m.signed_volume, 1.0 / 6, 1e-16);
  EXPECT_NEAR(m.area, 1.5 + std::sqrt(3.0) / 2, 1e-15);
  EXPECT_EQ(mesh_measure(gallery::flipped(gallery::tetrahedron())).signed_volume, -m.signed_volume);
}

TEST(MeshMeasure, TorusTendsToItsFormulas) {
  const MeshMeasure m = mesh_measure(gallery::torus(400, 200, 2, 0.75));
  constexpr double pi = 3.141592653589793;
  EXPECT_NEAR(m.area, 4 * pi * pi * 2 * 0.75, 1e-2);
  EXPECT_NEAR(m.signed_volume, 2 * pi * pi * 2 * 0.75 * 0.75, 1e-2);
}

TEST(MeshMeasure, VolumeFarFromTheOriginKeepsItsDigits) {
  const TriangleMesh far = gallery::translated(gallery::cube(), {0x1p40, -0x1p41, 0x1p42});
  EXPECT_EQ(mesh_measure(far).signed_volume, 1);
  EXPECT_EQ(mesh_measure(far).area, 6);
}

TEST(MeshMeasure, RigidMotionAndScalingAreExact) {
  const TriangleMesh mesh = gallery::torus(9, 7);
  const MeshMeasure m = mesh_measure(mesh);
  const MeshMeasure scaled = mesh_measure(gallery::scaled(mesh, 0x1p-30));
  EXPECT_EQ(scaled.area, m.area * 0x1p-60);
  EXPECT_EQ(scaled.signed_volume, m.signed_volume * 0x1p-90);
  EXPECT_EQ(scaled.edge_lengths.median, m.edge_lengths.median * 0x1p-30);
  const MeshMeasure shuffled = mesh_measure(gallery::shuffled(mesh, 4));
  EXPECT_NEAR(shuffled.area, m.area, 1e-14 * m.area);
  EXPECT_NEAR(shuffled.signed_volume, m.signed_volume, 1e-14 * m.signed_volume);
  EXPECT_EQ(shuffled.edge_lengths.median, m.edge_lengths.median);
  EXPECT_EQ(shuffled.box, m.box);
}

TEST(MeshMeasure, DecilesOfEdgeLengths) {
  // Ten triangles in a row would share edges; ten apart have 30 edges of three lengths each.
  TriangleMesh mesh;
  for (int k = 1; k <= 10; ++k) {
    const auto length = static_cast<double>(k);
    const VertexId a = mesh.points.push_back({0, 100 * length, 0});
    const VertexId b = mesh.points.push_back({3 * length, 100 * length, 0});
    const VertexId c = mesh.points.push_back({0, 100 * length + 4 * length, 0});
    mesh.triangles.push_back({a, b, c});
  }
  const EdgeLengths edges = mesh_measure(mesh).edge_lengths;
  EXPECT_EQ(edges.count, 30U);
  EXPECT_EQ(edges.min, 3);
  EXPECT_EQ(edges.max, 50);
  // Sorted: 3 4 5 6 8 9 10 12 12 15 15 16 18 20 20 21 ...
  EXPECT_EQ(edges.first_decile, 6);
  EXPECT_EQ(edges.median, 21);
  EXPECT_EQ(edges.last_decile, 40);
}

// Areas square products of lengths: at these sizes they would leave the range of double.
TEST(MeshMeasure, CoordinatesOfAnySize) {
  const TriangleMesh sphere = gallery::sphere(2);
  const MeshMeasure m = mesh_measure(sphere);
  for (const int exponent : {-600, -300, 300, 500}) {
    const double factor = std::ldexp(1.0, exponent);
    const MeshMeasure scaled = mesh_measure(gallery::scaled(sphere, factor));
    EXPECT_EQ(scaled.area, std::ldexp(m.area, 2 * exponent)) << exponent;
    EXPECT_EQ(scaled.signed_volume, std::ldexp(m.signed_volume, 3 * exponent)) << exponent;
    EXPECT_EQ(scaled.box.high, factor * m.box.high) << exponent;
    EXPECT_EQ(scaled.edge_lengths.count, m.edge_lengths.count) << exponent;
    EXPECT_EQ(scaled.edge_lengths.min, factor * m.edge_lengths.min) << exponent;
    EXPECT_EQ(scaled.edge_lengths.mean, factor * m.edge_lengths.mean) << exponent;
  }
}

// Small triangles far from the center of the box, which their areas do not depend on.
TEST(MeshMeasure, AreaOfSmallTrianglesInALargeBox) {
  TriangleMesh mesh;
  constexpr double size = 0x1p-30;
  for (const double x : {-1.1, 0.7}) {
    const VertexId a = mesh.points.push_back({x, 0.3, x / 3});
    const VertexId b = mesh.points.push_back({x + size, 0.3, x / 3});
    const VertexId c = mesh.points.push_back({x, 0.3 + size, x / 3});
    mesh.triangles.push_back({a, b, c});
  }
  EXPECT_EQ(mesh_measure(mesh).area, size * size);
}

TEST(MeshMeasure, RefusesWhatItCannotMeasure) {
  TriangleMesh mesh = gallery::cube();
  mesh.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  EXPECT_EQ(mesh_measure(mesh).area, 6) << "no triangle uses it";
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    mesh.points[VertexId(3)].x = x;
    EXPECT_THROW(mesh_measure(mesh), InputError) << x;
  }
  TriangleMesh torn = gallery::cube();
  torn.triangles[TriangleId(0)][0] = VertexId(100);
  EXPECT_THROW(mesh_measure(torn), InputError);
}

TEST(MeshMeasure, NoTriangles) {
  TriangleMesh mesh;
  mesh.points.push_back({1, 2, 3});
  const MeshMeasure m = mesh_measure(mesh);
  EXPECT_EQ(m.area, 0);
  EXPECT_EQ(m.signed_volume, 0);
  EXPECT_TRUE(m.box.is_empty());
  EXPECT_EQ(m.edge_lengths.count, 0U);
}

}  // namespace
}  // namespace cocoon
