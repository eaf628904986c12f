#include "geom/surface_distance.h"

#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "ref/brute_force_closest_facet.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TriangleMesh cloud(std::initializer_list<Point> points) {
  TriangleMesh mesh;
  for (const Point& p : points) mesh.points.push_back(p);
  return mesh;
}

TEST(SurfaceDistance, OfASurfaceToItselfIsZero) {
  const TriangleMesh mesh = gallery::cube();
  const SurfaceDistance d = surface_distance(mesh, mesh, {.samples = 2000});
  EXPECT_LE(d.max, 1e-15);
  EXPECT_LE(d.rms, 1e-15);
  EXPECT_EQ(d.a_to_b.samples, 2008U);
}

TEST(SurfaceDistance, ParallelPatchesAreEverywhereAsFarApart) {
  const TriangleMesh patch = gallery::open_patch(4, 4);
  const SurfaceDistance d =
      surface_distance(patch, gallery::translated(patch, {0, 0, 0.5}), {.samples = 1000});
  EXPECT_EQ(d.max, 0.5);
  EXPECT_NEAR(d.mean, 0.5, 1e-15);
  EXPECT_NEAR(d.rms, 0.5, 1e-15);
  EXPECT_EQ(d.a_to_b.farthest, (Point{0, 0, 0}));
  EXPECT_EQ(d.b_to_a.farthest, (Point{0, 0, 0.5}));
}

TEST(SurfaceDistance, LargerPatchIsFarFromSmallerOnlyOneWay) {
  // [0,2]x[0,1] against [0,1]x[0,1]: the far half is at distance x - 1.
  const TriangleMesh large = gallery::open_patch(1, 2);
  const TriangleMesh small = gallery::open_patch(1, 1);
  const SurfaceDistance d = surface_distance(large, small, {.samples = 40000});
  EXPECT_EQ(d.a_to_b.max, 1);
  EXPECT_NEAR(d.a_to_b.mean, 0.25, 2e-3);               // half of the mean of (x - 1) on [1,2]
  EXPECT_NEAR(d.a_to_b.rms, std::sqrt(1.0 / 6), 2e-3);  // half of the mean of (x - 1)^2
  EXPECT_LE(d.b_to_a.max, 1e-15);
  EXPECT_EQ(d.max, 1);
  EXPECT_NEAR(d.mean, 0.125, 1e-3);
  EXPECT_NEAR(d.rms, std::sqrt(1.0 / 12), 2e-3);
}

TEST(SurfaceDistance, SpheresOfTwoRadii) {
  const TriangleMesh inner = gallery::sphere(4);
  const SurfaceDistance d = surface_distance(inner, gallery::scaled(inner, 1.5), {.samples = 5000});
  EXPECT_NEAR(d.mean, 0.5, 5e-3);
  EXPECT_NEAR(d.max, 0.5, 5e-3);
}

TEST(SurfaceDistance, CloudsAreMeasuredPointByPoint) {
  const TriangleMesh a = cloud({{0, 0, 0}, {1, 0, 0}});
  const TriangleMesh b = cloud({{0, 0, 0}, {1, 0, 3}, {0, 4, 0}});
  const SurfaceDistance d = surface_distance(a, b);
  EXPECT_EQ(d.a_to_b, (DirectedDistance{2, 1, 0.5, std::sqrt(0.5), {1, 0, 0}}));
  EXPECT_EQ(d.b_to_a.max, 4);
  EXPECT_EQ(d.b_to_a.mean, (0.0 + 3 + 4) / 3);
  EXPECT_EQ(d.b_to_a.farthest, (Point{0, 4, 0}));
}

TEST(SurfaceDistance, CloudAgainstMesh) {
  const SurfaceDistance d =
      surface_distance(cloud({{0.5, 0.5, 2}}), gallery::cube(), {.samples = 1000});
  EXPECT_EQ(d.a_to_b.max, 1);
  EXPECT_EQ(d.a_to_b.samples, 1U);
  EXPECT_EQ(d.b_to_a.max, std::sqrt(0.25 + 0.25 + 4));  // from a lower corner
}

TEST(SurfaceDistance, WithoutSamplesTheVerticesAgreeWithBruteForce) {
  const TriangleMesh a = gallery::torus(12, 8);
  const TriangleMesh b = gallery::translated(gallery::sphere(2), {1.5, 0.2, 0.1});
  const SurfaceDistance d = surface_distance(a, b, {.samples = 0});
  double farthest = 0;
  for (const Point& p : a.points) {
    farthest = std::max(farthest, ref::brute_force_closest_facet(b, p).squared_distance);
  }
  EXPECT_NEAR(d.a_to_b.max, std::sqrt(farthest), 1e-14);
  EXPECT_EQ(d.a_to_b.mean, 0);
  EXPECT_EQ(d.a_to_b.samples, 96U);
}

TEST(SurfaceDistance, SameForAllThreadCountsAndExactUnderScaling) {
  const TriangleMesh a = gallery::torus(12, 8);
  const TriangleMesh b = gallery::torus(13, 7);
  const SurfaceDistance expected = surface_distance(a, b, {.samples = 10000});
  EXPECT_EQ(surface_distance(a, b, {.samples = 10000}, {.threads = 4}), expected);
  const SurfaceDistance scaled = surface_distance(gallery::scaled(a, 0x1p-20),
                                                  gallery::scaled(b, 0x1p-20), {.samples = 10000});
  EXPECT_EQ(scaled.max, expected.max * 0x1p-20);
  EXPECT_EQ(scaled.rms, expected.rms * 0x1p-20);
  const SurfaceDistance swapped = surface_distance(b, a, {.samples = 10000});
  EXPECT_EQ(swapped.a_to_b, expected.b_to_a);
  EXPECT_EQ(swapped.mean, expected.mean);
  EXPECT_NE(surface_distance(a, b, {.samples = 10000, .seed = 2}).mean, expected.mean);
}

TEST(SurfaceDistance, VerticesThatNoTriangleUsesDoNotCount) {
  TriangleMesh mesh = gallery::cube();
  mesh.points.push_back({100, 0, 0});
  EXPECT_LE(surface_distance(mesh, gallery::cube(), {.samples = 100}).max, 1e-15);
}

TEST(SurfaceDistance, RefusesWhatItCannotMeasure) {
  EXPECT_THROW(surface_distance(TriangleMesh{}, gallery::cube()), InputError);
  EXPECT_THROW(surface_distance(gallery::cube(), TriangleMesh{}), InputError);
  TriangleMesh bad = gallery::cube();
  bad.points[VertexId(3)].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(surface_distance(bad, gallery::cube()), InputError);
  const TriangleMesh flat = gallery::make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_THROW(surface_distance(flat, gallery::cube()), InputError);
  EXPECT_EQ(surface_distance(flat, gallery::cube(), {.samples = 0}).a_to_b.max, 1);
}

}  // namespace
}  // namespace cocoon
