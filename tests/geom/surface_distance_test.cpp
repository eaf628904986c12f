#include "geom/surface_distance.h"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

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

TEST(SurfaceDistance, TellsTheShareWithinATolerance) {
  const TriangleMesh large = gallery::open_patch(1, 2);
  const TriangleMesh small = gallery::open_patch(1, 1);
  for (const double scale : {1.0, 0x1p+400, 0x1p-400}) {
    const SurfaceDistance d =
        surface_distance(gallery::scaled(large, scale), gallery::scaled(small, scale),
                         {.samples = 40000, .tolerance = 0.5 * scale});
    EXPECT_NEAR(d.a_to_b.within, 0.75, 3e-3) << scale;
    EXPECT_EQ(d.b_to_a.within, 1) << scale;
    EXPECT_NEAR(d.f_score, 2 * 0.75 / 1.75, 3e-3) << scale;
  }
  EXPECT_EQ(surface_distance(large, small, {.samples = 100}).f_score, 0);
  // On it counts as within, also where nothing may be off.
  EXPECT_EQ(surface_distance(cloud({{0, 0, 0}, {1, 0, 0}}), cloud({{0, 0, 0}}), {.tolerance = 0})
                .a_to_b.within,
            0.5);
  for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(surface_distance(large, small, {.tolerance = wrong}), InputError);
  }
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

TriangleMesh tent(double top) {
  return gallery::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, top}, {2, 2, 2}, {4, 2, 2}},
                            {{0, 1, 2}, {0, 1, 3}, {4, 5, 0}});
}

// Squares of areas of the one vanish beside those of the other.
TEST(SurfaceDistance, MeshesMayDifferInSizeAsMuchAsNumbersDo) {
  const TriangleMesh cube = gallery::translated(gallery::cube(), {3, 0, 0});
  for (const double factor : {1e-300, 1e-100, 1e-80, 1e80, 1e100, 1e150, 1e300}) {
    const TriangleMesh other = gallery::scaled(cube, factor);
    const SurfaceDistance d = surface_distance(cube, other, {.samples = 1000});
    const double size = std::max(1.0, factor);
    EXPECT_NEAR(d.max / size, std::sqrt(18), 1e-12) << factor;
    const DirectedDistance& of_larger = factor > 1 ? d.b_to_a : d.a_to_b;
    const DirectedDistance& of_smaller = factor > 1 ? d.a_to_b : d.b_to_a;
    EXPECT_NEAR(of_smaller.mean / size, 3, 1e-12) << factor;
    EXPECT_NEAR(of_larger.mean / size, 3.62, 0.01) << factor;
  }
}

// What is near is measured as if the corner far out were not there.
TEST(SurfaceDistance, OneCornerMayBeFarOut) {
  const TriangleMesh near = tent(2);
  const auto moved = [](double top) { return gallery::translated(tent(top), {0, 0.25, 0}); };
  const DirectedDistance expected = surface_distance(near, moved(1e9), {.samples = 1000}).a_to_b;
  EXPECT_GT(expected.mean, 0);
  for (const double top : {1e16, 1e30, 1e60, 1e80, 1e100}) {
    const SurfaceDistance d = surface_distance(near, moved(top), {.samples = 1000});
    EXPECT_NEAR(d.a_to_b.mean, expected.mean, 1e-6) << top;
    EXPECT_NEAR(d.a_to_b.max, expected.max, 1e-6) << top;
    EXPECT_NEAR(d.b_to_a.max / top, 1, 1e-12) << top;
    EXPECT_NEAR(d.b_to_a.mean / top, 1.0 / 3, 0.01) << top;
  }
}

TEST(SurfaceDistance, AVertexThatNoTriangleUsesMayBeFarOut) {
  const SurfaceDistance expected =
      surface_distance(gallery::cube(), gallery::torus(9, 6), {.samples = 100});
  TriangleMesh mesh = gallery::cube();
  mesh.points.push_back({1e200, 0, 0});
  EXPECT_EQ(surface_distance(mesh, gallery::torus(9, 6), {.samples = 100}), expected);
}

// Rounding makes all triangles equally far from what is far out, and one corner far out must not
// make all boxes of the search as large. Of each sample against each triangle this takes minutes.
TEST(SurfaceDistance, FarCornersTakeNoMoreTime) {
  const TriangleMesh near = gallery::sphere(6);
  TriangleMesh far = near;
  far.points[VertexId(0)] = {1e16, 0, 0};
  const auto start = std::chrono::steady_clock::now();
  const SurfaceDistance d = surface_distance(near, far, {.samples = 100000});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  EXPECT_EQ(d.b_to_a.max, 1e16);
}

TEST(SurfaceDistance, RefusesWhatItCannotMeasure) {
  EXPECT_THROW(surface_distance(TriangleMesh{}, gallery::cube()), InputError);
  EXPECT_THROW(surface_distance(gallery::cube(), TriangleMesh{}), InputError);
  TriangleMesh bad = gallery::cube();
  bad.points[VertexId(3)].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(surface_distance(bad, gallery::cube()), InputError);
  TriangleMesh torn = gallery::cube();
  torn.triangles[TriangleId(2)][1] = VertexId(1000000);
  EXPECT_THROW(surface_distance(torn, gallery::cube()), InputError);
  EXPECT_THROW(surface_distance(gallery::cube(), torn), InputError);
  const TriangleMesh flat = gallery::make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  const auto refusal = [](const TriangleMesh& a, const TriangleMesh& b) -> std::string {
    try {
      surface_distance(a, b);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(flat, gallery::cube()).find("of the first have no area"), std::string::npos);
  EXPECT_NE(refusal(gallery::cube(), flat).find("of the second have no area"), std::string::npos);
  EXPECT_EQ(surface_distance(flat, gallery::cube(), {.samples = 0}).a_to_b.max, 1);
}

}  // namespace
}  // namespace cocoon
