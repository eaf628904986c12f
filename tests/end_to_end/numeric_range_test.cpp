// Coordinates of any size: what docs/formats.md ("Numeric range") admits gives the same surface as
// at ordinary size, the rest is refused with the reason.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/surface_distance.h"
#include "io/sample_models.h"
#include "tests/gallery.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

std::vector<Point> scaled(std::vector<Point> points, double factor) {
  for (Point& p : points) p = factor * p;
  return points;
}

// Positions on a lattice of 2^-20: scaling by a power of two is exact down to the subnormal
// numbers.
std::vector<Point> lattice_torus(std::size_t count) {
  std::vector<Point> points = gallery::displaced_torus(count);
  const auto snapped = [](double value) {
    return std::ldexp(std::round(std::ldexp(value, 20)), -20);
  };
  for (Point& p : points) p = {snapped(p.x), snapped(p.y), snapped(p.z)};
  return points;
}

std::string message_of_reconstruct(const std::vector<Point>& points) {
  try {
    reconstruct_tight(points);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(NumericRange, PowersOfTwoChangeNothing) {
  const std::vector<Point> points = lattice_torus(1500);
  const TriangleMesh tight = reconstruct_tight(points).mesh;
  const TriangleMesh open = reconstruct_cocone(points).mesh;
  ASSERT_GT(tight.triangles.size(), 2000U);
  for (const int exponent : {-1054, -1000, -500, -101, -99, 99, 101, 500, 1000, 1022}) {
    const std::vector<Point> moved = scaled(points, std::ldexp(1.0, exponent));
    EXPECT_EQ(reconstruct_tight(moved, {.verify = true}).mesh.triangles, tight.triangles)
        << exponent;
    EXPECT_EQ(reconstruct_cocone(moved).mesh.triangles, open.triangles) << exponent;
  }
}

TEST(NumericRange, DecimalSizesAndSurveyOffsets) {
  const std::vector<Point> points = gallery::displaced_torus(1500);
  for (const double factor : {1e-300, 1e-150, 1e150, 1e300}) {
    const ReconstructResult result = reconstruct_tight(scaled(points, factor), {.verify = true});
    ASSERT_EQ(result.status, SurfaceStatus::ok) << factor;
    EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold()) << factor;
    EXPECT_EQ(result.unused_points, 0U) << factor;
  }
  // A kilometer of torus, sampled to the millimeter, far from the origin.
  std::vector<Point> survey = scaled(points, 1000);
  for (Point& p : survey) p = p + Vec3{1e7, -5e6, 3e3};
  const ReconstructResult result = reconstruct_tight(survey, {.verify = true});
  ASSERT_EQ(result.status, SurfaceStatus::ok);
  EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
  EXPECT_EQ(result.unused_points, 0U);
}

TEST(NumericRange, SizesThatNoScaleHoldsAreRefusedWithTheReason) {
  std::vector<Point> points = scaled(gallery::displaced_torus(500), 1e150);
  EXPECT_EQ(message_of_reconstruct(points), "");
  points[3].x = 1e-200;
  EXPECT_NE(message_of_reconstruct(points).find("2^100"), std::string::npos);
  EXPECT_THROW(reconstruct_cocone(points), InputError);
  points[3].x = 1e-100;  // fits
  EXPECT_EQ(message_of_reconstruct(points), "");
  points[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of_reconstruct(points).find("not finite"), std::string::npos)
      << message_of_reconstruct(points);
}

TEST(NumericRange, OnePointFarOutGivesTheSameSurfaceOrIsNamed) {
  std::vector<Point> points = gallery::displaced_torus(1500);
  const std::size_t triangles = reconstruct_tight(points).mesh.triangles.size();
  points.push_back({});
  for (const double far : {1e20, 1e40, 1e59}) {
    points.back() = {0, far, -far};
    EXPECT_EQ(reconstruct_tight(points).mesh.triangles.size(), triangles) << far;
    EXPECT_GT(reconstruct_cocone(points).mesh.triangles.size(), triangles / 2) << far;
  }
  for (const double far : {1e61, 1e80, 1e90, 1e150}) {
    points.back() = {0, far, -far};
    const std::string named = "point " + std::to_string(points.size() - 1) + " at (0, ";
    EXPECT_EQ(message_of_reconstruct(points).find(named), 0U) << message_of_reconstruct(points);
    EXPECT_THROW(reconstruct_cocone(points), InputError) << far;
  }
}

// The same samples at every size.
TEST(NumericRange, DistancesScaleWithTheMeshes) {
  const TriangleMesh torus = reconstruct_tight(lattice_torus(500)).mesh;
  TriangleMesh larger = torus;
  for (Point& p : larger.points) p = 1.5 * p;
  const SurfaceDistance expected = surface_distance(torus, larger, {.samples = 1000});
  for (const int exponent : {-1000, -500, -201, -200, 199, 200, 500, 1000}) {
    TriangleMesh a = torus;
    TriangleMesh b = larger;
    const double factor = std::ldexp(1.0, exponent);
    for (Point& p : a.points) p = factor * p;
    for (Point& p : b.points) p = factor * p;
    const SurfaceDistance found = surface_distance(a, b, {.samples = 1000});
    EXPECT_EQ(found.max, factor * expected.max) << exponent;
    EXPECT_EQ(found.mean, factor * expected.mean) << exponent;
    EXPECT_EQ(found.b_to_a.rms, factor * expected.b_to_a.rms) << exponent;
    EXPECT_EQ(found.a_to_b.farthest, factor * expected.a_to_b.farthest) << exponent;
  }
}

// The triangulation itself takes them: exact, and slow.
TEST(NumericRange, DelaunayTakesAllSizesAtOnce) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<Point> points = {
      {0, 0, 0},    {tiny, 0, 0},    {0, tiny, 0},     {0, 0, tiny},  {1, 1, 1},
      {huge, 0, 0}, {0, huge, huge}, {-huge, 1, tiny}, {1, 2, -huge}, {1e-200, 1, 0}};
  const Triangulation triangulation = delaunay(points).triangulation;
  EXPECT_EQ(triangulation.num_vertices(), points.size());
  EXPECT_TRUE(check_delaunay(triangulation).ok());
}

// An update at the edges of its range, just beyond them, and far from the origin.
TEST(NumericRange, Update) {
  const SampleModel block = sample_model("block");
  const TriangleMesh model = reconstruct_tight(block.initial).mesh;
  const UpdateResult expected = update_model(model, block.clouds);
  ASSERT_EQ(expected.status, UpdateStatus::ok);
  double largest = 0;
  for (const Point& p : model.points) {
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  const int headroom = 199 - std::ilogb(largest);

  const auto update = [&](double factor, const Vec3& offset) {
    TriangleMesh moved_model = model;
    for (Point& p : moved_model.points) p = factor * p + offset;
    std::vector<std::vector<Point>> clouds = block.clouds;
    for (std::vector<Point>& cloud : clouds) {
      for (Point& p : cloud) p = factor * p + offset;
    }
    return update_model(moved_model, clouds);
  };
  for (const int exponent : {headroom, -headroom}) {
    EXPECT_EQ(update(std::ldexp(1.0, exponent), {}).mesh.triangles, expected.mesh.triangles);
  }
  for (const double factor : {0x1p250, 0x1p-250}) {
    EXPECT_THROW(update(factor, {}), InputError);
  }
  const UpdateResult survey = update(1, {1e7, -5e6, 3e3});
  ASSERT_EQ(survey.status, UpdateStatus::ok) << survey.message;
  EXPECT_TRUE(mesh_check(survey.mesh).is_closed_manifold());
}

}  // namespace
}  // namespace cocoon
