#include "io/sample_models.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ostream>

#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/search/closest_facet.h"
#include "geom/search/nearest_point.h"
#include "io/models/polygonize.h"
#include "io/models/sample_airbag.h"
#include "io/models/sample_block.h"
#include "io/models/sample_golf_club.h"

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

// By the definition: all weights are looked at for each point that goes.
std::vector<Point> eliminated_plainly(std::vector<Point> points, std::size_t count, double radius) {
  const double reach = 2 * radius;
  const auto weight = [&](const Point& a, const Point& b) {
    const double closeness = 1 - distance(a, b) / reach;
    const double squared = closeness * closeness;
    return closeness > 0 ? squared * squared * (squared * squared) : 0;
  };
  std::vector<double> weights(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) weights[i] += weight(points[i], points[j]);
    }
  }
  while (points.size() > count) {
    const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
    const Point gone = points[static_cast<std::size_t>(most)];
    points.erase(points.begin() + most);
    weights.erase(weights.begin() + most);
    for (std::size_t i = 0; i < points.size(); ++i) weights[i] -= weight(points[i], gone);
  }
  return points;
}

TEST(SurfaceSampling, EliminationIsThatOfItsDefinitionWithAnyThreads) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    std::vector<Point> points;
    for (int i = 0; i < 600; ++i) {
      // On a grid in part, so that there are ties.
      const double x = random.uniform(0, 20);
      const double y = random.uniform(0, 20);
      points.push_back(i % 2 == 0 ? Point{x, y, 0} : Point{std::floor(x), std::floor(y), 1});
    }
    const std::vector<Point> expected = eliminated_plainly(points, 150, 1.3);
    for (const int threads : {1, 3}) {
      EXPECT_EQ(eliminate_samples(points, 150, 1.3, {threads}), expected) << seed;
    }
  }
}

TEST(SurfaceSampling, EqualWithAnyThreads) {
  const ImplicitSolid solid = ball(1);
  const TriangleMesh mesh = polygonize(solid, 0.1);
  const auto cap = [](const Point& p) { return p.z > 0.5; };
  Random one(5);
  Random three(5);
  const std::vector<Point> expected = sample_surface(solid, mesh, cap, 1500, one);
  EXPECT_EQ(sample_surface(solid, mesh, cap, 1500, three, {3}), expected);
  EXPECT_EQ(one.uniform(0, 1), three.uniform(0, 1));  // as much was drawn
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
    const double figure = block_ridge_figure(p.x, p.y);
    if (replaced[k] != 0) {
      EXPECT_LT(design.after.value(p), 0.02 * 0.15);  // inside the new solid, but for the jitter
      EXPECT_LT(figure, 0.2 + 0.02 * 0.15);
    } else {
      EXPECT_LE(std::sqrt(truth.closest(p).squared_distance), 0.006);
      EXPECT_TRUE(p.z < 0.9 || figure > 0.2 - 0.02 * 0.15);
    }
  }
}

// The figures of the paper's table: samples, cloud samples and removed samples.
struct PaperCounts {
  const char* name;
  std::size_t points;
  std::size_t cloud_points;
  std::size_t removed;
  std::size_t clouds;
};
void PrintTo(const PaperCounts& model, std::ostream* out) { *out << model.name; }
constexpr PaperCounts paper_counts[] = {{"block", 5991, 11488, 422, 1},
                                        {"airbag", 28650, 34866, 2557, 3},
                                        {"golf-club", 49380, 4572, 382, 1},
                                        {"joystick-1", 37122, 10574, 1803, 1},
                                        {"joystick-2", 37122, 32187, 3353, 1}};

class SampleModelsOfThePaper : public ::testing::TestWithParam<PaperCounts> {};

TEST_P(SampleModelsOfThePaper, CountsShapesAndOutlines) {
  const PaperCounts paper = GetParam();
  const SampleModel model = sample_model(paper.name);

  // The counts.
  EXPECT_EQ(model.initial.size(), paper.points);
  ASSERT_EQ(model.clouds.size(), paper.clouds);
  std::size_t cloud_points = 0;
  for (const auto& cloud : model.clouds) cloud_points += cloud.size();
  EXPECT_EQ(cloud_points, paper.cloud_points);
  const auto removed = static_cast<double>(paper.removed);
  EXPECT_NEAR(static_cast<double>(model.replaced.size()), removed, 0.1 * removed);

  // The true surface.
  const MeshReport report = mesh_check(model.truth);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.genus, 0U);
  EXPECT_GT(mesh_measure(model.truth).signed_volume, 0);

  // All points that are there after the change lie on it; the clouds end
  // a little before those that stay.
  const double spacing =
      std::sqrt(mesh_measure(model.truth).area / 1.02 / static_cast<double>(model.initial.size()));
  const ClosestFacetTree truth(model.truth);
  std::vector<Point> all;
  for (const auto& cloud : model.clouds) {
    for (const Point& p : cloud) {
      EXPECT_LE(std::sqrt(truth.closest(p).squared_distance), 0.2 * spacing);
      all.push_back(p);
    }
  }
  const NearestPointTree scanned(all);
  std::vector<char> is_wrong(model.initial.size(), 0);
  for (const PointId p : model.replaced) is_wrong[p.index()] = 1;
  std::size_t close = 0;
  for (std::size_t k = 0; k < model.initial.size(); ++k) {
    const Point& p = model.initial[k];
    if (is_wrong[k] != 0) continue;
    EXPECT_LE(std::sqrt(truth.closest(p).squared_distance), 0.2 * spacing);
    if (scanned.nearest(p).squared_distance < 0.09 * spacing * spacing) ++close;
  }
  EXPECT_EQ(close, 0U);  // the outline keeps its distance from the points that stay
}

INSTANTIATE_TEST_SUITE_P(All, SampleModelsOfThePaper, ::testing::ValuesIn(paper_counts),
                         [](const auto& named) {
                           std::string name = named.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(SampleGolfClub, CloudLiesOnBothSidesOfTheOldSurface) {
  const SampleModelDesign design = golf_club_design();
  const SampleModel model = sample_model("golf-club", {.points = 20000});
  double deepest = 0;
  double highest = 0;
  for (const Point& p : model.clouds[0]) {
    deepest = std::min(deepest, design.before.value(p));
    highest = std::max(highest, design.before.value(p));
  }
  EXPECT_LT(deepest, -0.15);
  EXPECT_GT(highest, 0.15);
}

TEST(SampleAirbag, CloudsLieInsideTheOldSurface) {
  const SampleModelDesign design = airbag_design();
  const SampleModel model = sample_model("airbag", {.points = 8000, .cloud_points = 10001});
  std::size_t total = 0;
  for (const auto& cloud : model.clouds) {
    total += cloud.size();
    double deepest = 0;
    for (const Point& p : cloud) {
      EXPECT_LT(design.before.value(p), 0.01);
      deepest = std::min(deepest, design.before.value(p));
    }
    EXPECT_LT(deepest, -0.5);
  }
  EXPECT_EQ(total, 10001U);  // of all clouds together
}

TEST(SampleJoysticks, AreTwoChangesOfOnePart) {
  const SampleOptions options = {.points = 2000, .cloud_points = 2000};
  EXPECT_EQ(sample_model("joystick-1", options).initial,
            sample_model("joystick-2", options).initial);
}

// However few, if only one is where the change is.
TEST(SampleModels, FewPointsAreSampledOrSaidToBeTooFew) {
  for (const std::string name : {"block", "golf-club"}) {
    for (const std::size_t count : {4, 16, 256}) {
      SCOPED_TRACE(name + " " + std::to_string(count));
      try {
        const SampleOptions options = {.points = count, .cloud_points = 4 * count, .seed = count};
        EXPECT_EQ(sample_model(name, options).initial.size(), count);
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("ask for more points"), std::string::npos)
            << error.what();
      }
    }
  }
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

class StopAfter : public Progress {
 public:
  explicit StopAfter(std::size_t reports) : left_(reports) {}
  bool report(std::string_view, double) override { return left_-- > 1; }

 private:
  std::size_t left_;
};

// Asked often: in every phase, thousands of points apart.
TEST(SampleModels, StopWhenAsked) {
  for (const std::size_t reports : {1U, 5U, 20U, 50U}) {
    StopAfter stop(reports);
    EXPECT_THROW(sample_model("block", {.points = 20000}, {.threads = 1, .progress = &stop}),
                 Cancelled)
        << reports;
  }
}

TEST(SampleModels, RefusesOptionsOutOfRange) {
  EXPECT_THROW(sample_model("block", {.points = 3}), InputError);
  EXPECT_THROW(sample_model("block", {.cloud_points = 0}), InputError);
  EXPECT_THROW(sample_model("block", {.jitter = -1}), InputError);
  EXPECT_THROW(sample_model("airbag", {.cloud_points = 11}), InputError);
  EXPECT_THROW(sample_model("golf-club", {.points = 4}), InputError);  // none is on the change
  EXPECT_THROW(sample_model("block", {.points = most_sample_points + 1}), InputError);
  EXPECT_THROW(sample_model("block", {.cloud_points = most_sample_points + 1}), InputError);
}

}  // namespace
}  // namespace cocoon
