#include "io/sample_models.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "geom/closest_facet.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "io/polygonize.h"
#include "io/sample_block.h"

namespace cocoon {
namespace {

// The block at the paper's sizes; made once, as it takes a second or two.
const SampleModel& block() {
  static const SampleModel model = sample_model("block");
  return model;
}

ImplicitSolid ball(double radius) {
  const double reach = radius + 0.25;
  return {[radius](const Point& p) { return norm(p) - radius; },
          {{-reach, -reach, -reach}, {reach, reach, reach}}};
}

TEST(Polygonize, BallIsAClosedSphere) {
  const TriangleMesh mesh = polygonize(ball(1), 0.1);
  const MeshReport report = mesh_check(mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.genus, 0U);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.zero_area_triangles, 0U);
  const MeshMeasure measure = mesh_measure(mesh);
  constexpr double pi = 3.141592653589793;
  EXPECT_NEAR(measure.signed_volume, 4 * pi / 3, 0.02);
  EXPECT_NEAR(measure.area, 4 * pi, 0.05);
  for (const Point& p : mesh.points) EXPECT_NEAR(norm(p), 1, 1e-9);
}

TEST(Polygonize, TorusHasGenusOne) {
  const ImplicitSolid torus = {[](const Point& p) {
                                 const double ring = std::sqrt(p.x * p.x + p.y * p.y) - 1;
                                 return std::sqrt(ring * ring + p.z * p.z) - 0.3;
                               },
                               {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}}};
  const MeshReport report = mesh_check(polygonize(torus, 0.1));
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.genus, 1U);
}

TEST(Polygonize, GridPointsExactlyOnTheSurfaceDoNoHarm) {
  // The faces of this cube lie in planes of the grid.
  const ImplicitSolid cube = {
      [](const Point& p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.5;
      },
      {{-1, -1, -1}, {1, 1, 1}}};
  const MeshReport report = mesh_check(polygonize(cube, 0.25));
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.euler, 2);
}

TEST(Polygonize, RefusesWhatItCannotCut) {
  EXPECT_THROW(polygonize(ball(1), 0), InputError);
  EXPECT_THROW(polygonize(ball(1), 1e-9), InputError);
  ImplicitSolid tight = ball(1);
  tight.box = {{-1, -1, -0.5}, {1, 1, 0.5}};
  EXPECT_THROW(polygonize(tight, 0.1), InputError);
}

TEST(SurfaceSampling, PointsLieOnTheSurfaceApartFromEachOther) {
  Random random(3);
  const ImplicitSolid solid = ball(1);
  const auto everywhere = [](const Point&) { return true; };
  const std::size_t count = 500;
  const std::vector<Point> points =
      sample_surface(solid, polygonize(solid, 0.1), everywhere, count, random);
  ASSERT_EQ(points.size(), count);
  // Disks of this radius would cover the sphere if they could be packed without gaps.
  const double packing_radius = std::sqrt(4 * 3.141592653589793 / (2 * std::sqrt(3.0) * 500));
  double closest = 10;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_NEAR(norm(points[i]), 1, 1e-9);
    for (std::size_t j = 0; j < i; ++j) {
      closest = std::min(closest, distance(points[i], points[j]));
    }
  }
  EXPECT_GT(closest, 1.1 * packing_radius);  // 2 is the limit; random points reach about 0.04
}

TEST(SurfaceSampling, EliminationRemovesTheMostCrowdedFirst) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2.1, 0, 0}, {4, 0, 0}};
  const std::vector<Point> kept = eliminate_samples(points, 4, 1);
  EXPECT_EQ(kept, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2.1, 0, 0}, {4, 0, 0}}));
}

TEST(SurfaceSampling, RefusesARegionWithoutSurface) {
  Random random(3);
  const ImplicitSolid solid = ball(1);
  const auto nowhere = [](const Point& p) { return p.z > 5; };
  EXPECT_THROW(sample_surface(solid, polygonize(solid, 0.1), nowhere, 10, random), InputError);
}

TEST(SampleBlock, HasThePapersCounts) {
  EXPECT_EQ(block().initial.size(), 5991U);
  ASSERT_EQ(block().clouds.size(), 1U);
  EXPECT_EQ(block().clouds[0].size(), 11488U);
  EXPECT_NEAR(static_cast<double>(block().replaced.size()), 422, 15);
}

TEST(SampleBlock, TruthIsAClosedSurfaceOfGenusZero) {
  const MeshReport report = mesh_check(block().truth);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.genus, 0U);
  EXPECT_EQ(report.zero_area_triangles, 0U);
  const MeshMeasure measure = mesh_measure(block().truth);
  EXPECT_GT(measure.signed_volume, 8 * 5 * 2);  // block and ridge, less the rounded edges
  EXPECT_NEAR(measure.box.high.z, 1.5, 0.01);
  EXPECT_NEAR(measure.box.low.x, -4, 0.01);
}

TEST(SampleBlock, PointsLieOnTheirSurfacesWithinTheJitter) {
  const SampleModelDesign design = block_design();
  for (const Point& p : block().initial) EXPECT_LE(std::abs(design.before.value(p)), 0.02 * 0.15);
  for (const Point& p : block().clouds[0]) {
    EXPECT_LE(std::abs(design.after.value(p)), 0.02 * 0.05);
  }
}

TEST(SampleBlock, CloudAgreesWithTheTrueMesh) {
  const ClosestFacetTree tree(block().truth);
  for (const Point& p : block().clouds[0]) {
    EXPECT_LE(std::sqrt(tree.closest(p).squared_distance), 0.01);
  }
}

TEST(SampleBlock, ReplacedPointsAreThoseUnderTheRidge) {
  const SampleModelDesign design = block_design();
  std::vector<char> replaced(block().initial.size(), 0);
  for (const PointId id : block().replaced) replaced[id.index()] = 1;
  EXPECT_TRUE(std::is_sorted(block().replaced.begin(), block().replaced.end()));
  const ClosestFacetTree truth(block().truth);
  for (std::size_t k = 0; k < replaced.size(); ++k) {
    const Point& p = block().initial[k];
    if (replaced[k] != 0) {
      EXPECT_LT(design.after.value(p), 0.02 * 0.15);  // inside the new solid, but for the jitter
      EXPECT_TRUE(design.scanned[0](p));
    } else {
      EXPECT_LE(std::sqrt(truth.closest(p).squared_distance), 0.006);
    }
  }
}

TEST(SampleBlock, RimOfTheCloudLiesOnTheOldSurface) {
  const SampleModelDesign design = block_design();
  std::size_t on_rim = 0;
  for (const Point& p : block().clouds[0]) {
    if (block_ridge_figure(p.x, p.y) < 0.2) continue;  // the fillet
    ++on_rim;
    EXPECT_LE(std::abs(design.before.value(p)), 0.02 * 0.05);
  }
  EXPECT_GT(on_rim, 300U);
}

TEST(SampleModels, SizesAndSeedAreOptions) {
  const SampleOptions options = {.points = 500, .cloud_points = 700, .seed = 9};
  const SampleModel a = sample_model("block", options);
  EXPECT_EQ(a.initial.size(), 500U);
  EXPECT_EQ(a.clouds[0].size(), 700U);
  const SampleModel again = sample_model("block", options);
  EXPECT_EQ(a.initial, again.initial);
  EXPECT_EQ(a.clouds, again.clouds);
  EXPECT_EQ(a.replaced, again.replaced);
  EXPECT_EQ(a.truth, again.truth);
  const SampleModel other = sample_model("block", {.points = 500, .cloud_points = 700, .seed = 10});
  EXPECT_NE(a.initial, other.initial);
  EXPECT_EQ(a.truth, other.truth);
}

TEST(SampleModels, NoJitterGivesPointsOfTheSurface) {
  const SampleModel model =
      sample_model("block", {.points = 300, .cloud_points = 300, .jitter = 0});
  const SampleModelDesign design = block_design();
  for (const Point& p : model.initial) EXPECT_LE(std::abs(design.before.value(p)), 1e-10);
  for (const Point& p : model.clouds[0]) EXPECT_LE(std::abs(design.after.value(p)), 1e-10);
}

TEST(SampleModels, UnknownNameListsTheKnownOnes) {
  try {
    sample_model("teapot");
    FAIL() << "no exception";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("teapot"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("block"), std::string::npos);
  }
}

TEST(SampleModels, RefusesOptionsOutOfRange) {
  EXPECT_THROW(sample_model("block", {.points = 3}), InputError);
  EXPECT_THROW(sample_model("block", {.cloud_points = 0}), InputError);
  EXPECT_THROW(sample_model("block", {.jitter = -1}), InputError);
}

}  // namespace
}  // namespace cocoon
