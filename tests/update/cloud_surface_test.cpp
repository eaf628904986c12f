#include "update/cloud_surface.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/end_to_end/local_update.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

// A sheet z = bend * (x^2 + y^2) over the n x n grid of cells of size 1, jittered, where keep(x,
// y).
template <class Keep>
std::vector<Point> sheet(int n, double bend, double jitter, double noise, Keep keep) {
  Random random(31);
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double x = i - 0.5 * n + random.uniform(-jitter, jitter);
      const double y = j - 0.5 * n + random.uniform(-jitter, jitter);
      const double z = bend * (x * x + y * y) + random.uniform(-noise, noise);
      if (keep(x, y)) points.push_back({x, y, z});
    }
  }
  return points;
}
bool everywhere(double, double) { return true; }

TEST(CloudSurface, APatchHasOneRim) {
  const CloudSurface surface = cloud_surface(sheet(30, 0.02, 0.2, 0, everywhere));
  ASSERT_EQ(surface.status, CloudStatus::ok);
  EXPECT_EQ(surface.trials.size(), 1U);
  EXPECT_EQ(surface.search.rho, 0.3);
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  EXPECT_NEAR(surface.rim.loops[0].perimeter, 120, 12);
  EXPECT_EQ(surface.rim.pin_holes, 0U);
  EXPECT_LT(surface.rim.spacing, 2.5);
}

// As of a face where a boss was taken off: the points are exactly in one plane.
TEST(CloudSurface, AFlatPatchHasOneRim) {
  for (const double jitter : {0.2, 0.0}) {
    const std::vector<Point> flat = sheet(30, 0, jitter, 0, everywhere);
    const CloudSurface surface = cloud_surface(flat);
    ASSERT_EQ(surface.status, CloudStatus::ok);
    ASSERT_EQ(surface.rim.loops.size(), 1U);
    EXPECT_NEAR(surface.rim.loops[0].perimeter, 120, 12);
    EXPECT_GT(surface.mesh.triangles.size(), 1700U);
    for (const VertexId v : surface.mesh.points.ids()) {
      EXPECT_EQ(surface.mesh.points[v], flat[surface.point_of_vertex[v].index()]);
    }
  }
}

// The sheet of 30 spacings, heights with so much noise.
CloudSurface of_noisy_sheet(double noise) {
  return cloud_surface(sheet(30, 0.02, 0.2, noise, everywhere));
}

// How far the rim point closest to the middle of that sheet is from it; the outline is at 15.
double innermost(const CloudSurface& surface) {
  double least = 15;
  for (const RimLoop& loop : surface.rim.loops) {
    for (const Point& p : loop.points) {
      least = std::min(least, std::max(std::abs(p.x), std::abs(p.y)));
    }
  }
  return least;
}

// As good as without: the first trial finds the outline, and the surface is a disk.
TEST(CloudSurface, NoiseOfFivePercent) {
  const CloudSurface surface = of_noisy_sheet(0.05);
  ASSERT_EQ(surface.status, CloudStatus::ok);
  EXPECT_EQ(surface.trials.size(), 1U);
  EXPECT_EQ(surface.search.rho, 0.3);
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  EXPECT_NEAR(surface.rim.loops[0].perimeter, of_noisy_sheet(0).rim.loops.at(0).perimeter, 6);
  EXPECT_GT(innermost(surface), 14);
  const MeshReport check = mesh_check(surface.mesh);
  EXPECT_EQ(check.components, 1U);
  EXPECT_EQ(check.euler, 1);
  EXPECT_TRUE(check.edge_manifold && check.vertex_manifold);
  EXPECT_GT(surface.mesh.triangles.size(), 1780U);
}

// The first trial takes most samples for a boundary: its loops are seams. A larger rho bears it,
// though not without pin-holes.
TEST(CloudSurface, NoiseOfThirtyPercentNeedsACoarserTrial) {
  const CloudSurface surface = of_noisy_sheet(0.3);
  ASSERT_EQ(surface.status, CloudStatus::ok);
  EXPECT_GT(surface.trials[0].seam_share, 0.5);
  EXPECT_GT(surface.trials[0].boundary_samples, 500U);
  EXPECT_GT(surface.search.rho, 0.3);
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  EXPECT_GT(innermost(surface), 12);
}

// A hole in a sphere is found iff it is larger than rho times the distance to the medial axis, 1:
// each trial finds smaller ones. The smallest is no wider than two spacings.
TEST(CloudSurface, FinerTrialsFindSmallerHoles) {
  struct Hole {
    double polar;
    std::size_t trials;
    double rho;
  };
  for (const auto& [polar, trials, rho] :
       {Hole{0.32, 1, 0.3}, Hole{0.25, 2, 0.2}, Hole{0.19, 3, 0.13}, Hole{0.145, 4, 0.1}}) {
    std::vector<Point> cloud = testing::sphere_points(2000, 3);
    std::erase_if(cloud, [edge = polar](const Point& p) { return p.z > std::cos(edge); });
    const CloudSurface surface = cloud_surface(cloud);
    ASSERT_EQ(surface.status, CloudStatus::ok) << polar;
    EXPECT_EQ(surface.trials.size(), trials) << polar;
    EXPECT_EQ(surface.search.rho, rho) << polar;
    ASSERT_EQ(surface.rim.loops.size(), 1U) << polar;
    for (const Point& p : surface.rim.loops[0].points) {
      EXPECT_LT(std::acos(p.z), polar + 0.09) << polar;
    }
  }
  std::vector<Point> cloud = testing::sphere_points(2000, 3);
  std::erase_if(cloud, [](const Point& p) { return p.z > std::cos(0.08); });
  EXPECT_EQ(cloud_surface(cloud).status, CloudStatus::cloud_closed);
}

TEST(CloudSurface, AHoleIsARim) {
  const CloudSurface surface = cloud_surface(
      sheet(40, 0.01, 0.2, 0, [](double x, double y) { return std::hypot(x, y) > 7; }));
  ASSERT_EQ(surface.status, CloudStatus::ok);
  ASSERT_EQ(surface.rim.loops.size(), 2U);
}

// A U: the slot is 8 spacings wide and 20 deep; whatever bridges it is trimmed.
TEST(CloudSurface, ASlotStaysOpen) {
  const CloudSurface surface = cloud_surface(
      sheet(40, 0.004, 0.2, 0, [](double x, double y) { return std::abs(x) > 4 || y < 0; }));
  ASSERT_EQ(surface.status, CloudStatus::ok);
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  EXPECT_NEAR(surface.rim.loops[0].perimeter, 160 + 40, 16);
}

// Two half sheets at a right angle: sharp edges need the coarser trials, and the rim is the outline
// of both halves together.
TEST(CloudSurface, ASharpFoldIsNoRim) {
  std::vector<Point> cloud;
  Random random(8);
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 30; ++j) {
      const double x = i + random.uniform(-0.2, 0.2);
      const double y = j + random.uniform(-0.2, 0.2);
      const double bend = 0.003 * (y - 15) * (y - 15);
      cloud.push_back({x, y, bend});
      if (i > 0) cloud.push_back({bend, y, x});
    }
  }
  const CloudSurface surface = cloud_surface(cloud);
  ASSERT_EQ(surface.status, CloudStatus::ok);
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  EXPECT_GT(surface.rim.loops[0].perimeter, 120);
  ASSERT_EQ(surface.trials.size(), 3U);
  EXPECT_EQ(surface.search.rho, 0.83);
  EXPECT_GT(surface.trials[0].seam_share, 0.3);
  EXPECT_LE(surface.trials[2].seam_share, 0.05);
}

TEST(CloudSurface, AClosedCloudHasNoRim) {
  Random random(4);
  std::vector<Point> sphere;
  sphere.reserve(1500);
  for (int i = 0; i < 1500; ++i) sphere.push_back(random.on_unit_sphere());
  const CloudSurface surface = cloud_surface(sphere);
  EXPECT_EQ(surface.status, CloudStatus::cloud_closed);
  EXPECT_TRUE(surface.rim.loops.empty());
  EXPECT_GT(surface.trials.size(), 1U);
}

// Four scans of a sheet, each a little out of register.
std::vector<Point> four_layers() {
  std::vector<Point> layers;
  for (int k = 0; k < 4; ++k) {
    for (const Point& p : sheet(30, 0.02, 0.2, 0.1, everywhere)) {
      layers.push_back(p + Vec3{0.3 * k, 0.5 * (k % 2), 0.15 * k});
    }
  }
  return layers;
}

TEST(CloudSurface, LayersOverEachOtherAreOne) {
  const std::vector<Point> layers = four_layers();
  const CloudSurface surface = cloud_surface(layers);
  ASSERT_EQ(surface.status, CloudStatus::ok);
  EXPECT_TRUE(surface.is_layered);
  EXPECT_GT(surface.set_aside, layers.size() / 2);
  EXPECT_GT(surface.trials.size(), 4U);
  for (const VertexId v : surface.mesh.points.ids()) {
    EXPECT_EQ(surface.mesh.points[v], layers[surface.point_of_vertex[v].index()]);
  }
  // Most of the rim is the outline.
  std::size_t points = 0;
  std::size_t inside = 0;
  for (const RimLoop& loop : surface.rim.loops) {
    for (const Point& p : loop.points) {
      ++points;
      inside += std::max(std::abs(p.x - 0.45), std::abs(p.y - 0.25)) < 11 ? 1U : 0U;
    }
  }
  EXPECT_GT(points, 80U);
  EXPECT_LT(4 * inside, points);
}

TEST(CloudSurface, NoLayerIsSetAsideIfThatIsOffAsInPaperMode) {
  CloudSurfaceOptions options;
  options.layers.spread = 0;
  for (const CloudSurfaceOptions& off : {options, paper_update_options().cloud}) {
    const CloudSurface torn = cloud_surface(four_layers(), off);
    EXPECT_FALSE(torn.is_layered);
    EXPECT_EQ(torn.set_aside, 0U);
    for (const RimTrial& trial : torn.trials) {
      EXPECT_TRUE(trial.loops == 0 || trial.seam_share > 0.3);
    }
  }
}

// Samples `distance` apart on one half, 1 on the other.
std::vector<Point> uneven_sheet(double distance, double bend, double jitter) {
  std::vector<Point> cloud;
  for (const Point& p : sheet(30, bend, jitter, 0, everywhere)) {
    if (p.x < 0) cloud.push_back(p);
  }
  const int cells = static_cast<int>(30 / distance);
  for (const Point& p : sheet(cells, bend * distance, jitter, 0, everywhere)) {
    if (p.x >= 0) cloud.push_back(distance * p);
  }
  return cloud;
}

// The rim is looked for among samples that are about as far apart everywhere.
TEST(CloudSurface, ARimOfUnevenSamplesHasOneSpacing) {
  const std::vector<Point> cloud = uneven_sheet(0.4, 0.02, 0.2);
  CloudSurfaceOptions options;
  options.density.min_ratio = 0;
  const CloudSurface of_all = cloud_surface(cloud, options);
  EXPECT_EQ(of_all.set_aside, 0U);
  EXPECT_TRUE(of_all.spacing.is_uneven(2));
  const CloudSurface surface = cloud_surface(cloud);
  EXPECT_EQ(surface.spacing.high, of_all.spacing.high);
  EXPECT_GT(surface.set_aside, cloud.size() / 2);
  EXPECT_FALSE(spacing_range(surface.mesh).is_uneven(2));
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  for (const VertexId v : surface.mesh.points.ids()) {
    EXPECT_EQ(surface.mesh.points[v], cloud[surface.point_of_vertex[v].index()]);
  }
  options.density = {.min_ratio = 2, .spread = 1000};  // which leaves one sample
  EXPECT_EQ(cloud_surface(cloud, options).set_aside, 0U);
}

// Neither of the rims of few samples is the less doubtful one. Edges of the first are as long as
// those of its surface, of the second two and a half times as long.
TEST(CloudSurface, AGoodRimOfFewSamplesHasNoLongEdges) {
  const auto set_aside = [](const std::vector<Point>& cloud, double max_stretch) {
    CloudSurfaceOptions options;
    options.density.max_stretch = max_stretch;
    return cloud_surface(cloud, options).set_aside;
  };
  const double usual = DensityOptions{}.max_stretch;
  const std::vector<Point> even_rim = uneven_sheet(0.4, 0.05, 0);
  EXPECT_GT(set_aside(even_rim, usual), even_rim.size() / 2);
  EXPECT_EQ(set_aside(even_rim, 1), 0U);
  const std::vector<Point> long_edges = uneven_sheet(0.45, 0.01, 0.2);
  EXPECT_EQ(set_aside(long_edges, usual), 0U);
  EXPECT_GT(set_aside(long_edges, 3), long_edges.size() / 2);
}

TEST(CloudSurface, OrderAndThreadsDoNotMatter) {
  std::vector<Point> cloud = sheet(20, 0.02, 0.3, 0.02, everywhere);
  const CloudSurface expected = cloud_surface(cloud);
  Random(3).shuffle(cloud);
  const CloudSurface shuffled = cloud_surface(cloud, {}, {.threads = 3});
  EXPECT_EQ(shuffled.mesh.points, expected.mesh.points);
  EXPECT_EQ(shuffled.mesh.triangles, expected.mesh.triangles);
  ASSERT_EQ(shuffled.rim.loops.size(), expected.rim.loops.size());
  for (std::size_t l = 0; l < expected.rim.loops.size(); ++l) {
    EXPECT_EQ(shuffled.rim.loops[l].perimeter, expected.rim.loops[l].perimeter);
    EXPECT_EQ(shuffled.rim.loops[l].vertices, expected.rim.loops[l].vertices);
    EXPECT_EQ(shuffled.rim.loops[l].normals, expected.rim.loops[l].normals);
  }
  for (const VertexId v : shuffled.mesh.points.ids()) {
    EXPECT_EQ(shuffled.mesh.points[v], cloud[shuffled.point_of_vertex[v].index()]);
  }
}

// A lone sample beyond a rim is no cloud because it is there twice.
TEST(CloudSurface, SamplesGivenTwiceChangeNoRim) {
  std::vector<Point> points;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y) {
      points.push_back({double(x), double(y), 0.01 * (x * x + y * y)});
    }
  }
  const CloudSurface once = cloud_surface(points);
  EXPECT_GT(once.rim.lone_edges, 0U);
  points.insert(points.end(), points.begin(), points.begin() + 400);
  const CloudSurface twice = cloud_surface(points);
  EXPECT_EQ(twice.mesh, once.mesh);
  EXPECT_EQ(twice.rim.lone_edges, once.rim.lone_edges);
  EXPECT_EQ(twice.rim.seam_edges, once.rim.seam_edges);
  EXPECT_EQ(twice.rim.is_partial(), once.rim.is_partial());
}

// In paper mode each trial measures the radius of the cocone (docs/departures.md).
TEST(CloudSurface, PaperModeHoldsInAllTrials) {
  const std::vector<Point> cloud = sheet(30, 0.02, 0.4, 0.6, everywhere);
  CloudSurfaceOptions options;
  const CloudSurface robust = cloud_surface(cloud, options);
  options.reconstruct.mode = Mode::paper;
  const CloudSurface paper = cloud_surface(cloud, options);
  ASSERT_GT(paper.trials.size(), 3U);
  for (const RimTrial& trial : paper.trials) {
    EXPECT_EQ(trial.search.radius_mode, RadiusMode::cocone);
  }
  EXPECT_EQ(paper.trials[1].boundary_samples, robust.trials[1].boundary_samples);
  EXPECT_NE(paper.trials[2].boundary_samples, robust.trials[2].boundary_samples);
}

TEST(CloudSurface, RejectsWhatCannotBeTriangulated) {
  const std::vector<Point> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 0, 0}};
  EXPECT_THROW(cloud_surface(line), InputError);
  EXPECT_THROW(cloud_surface(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), InputError);
  EXPECT_THROW(cloud_surface({}), InputError);
}

}  // namespace
}  // namespace cocoon
