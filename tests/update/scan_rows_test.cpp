#include "update/scan_rows.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/random/random.h"
#include "update/cloud_surface.h"

namespace cocoon {
namespace {

// A curved sheet in rows a unit apart, `ratio` samples for each unit along a row.
std::vector<Point> rows(double ratio, double across, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Point> points;
  for (int i = -12; i <= 12; ++i) {
    const double begin = random.uniform();
    for (int k = 0; k < static_cast<int>(24 * ratio); ++k) {
      const double x = (k + begin + random.uniform(-0.2, 0.2)) / ratio - 12;
      const double y = i + random.uniform(-across, across) / ratio;
      points.push_back({x, y, 0.01 * (x * x + y * y)});
    }
  }
  return points;
}

std::vector<Point> random_sheet(std::size_t count) {
  Random random(3);
  std::vector<Point> points;
  while (points.size() < count) {
    const double x = random.uniform(-12, 12);
    const double y = random.uniform(-12, 12);
    points.push_back({x, y, 0.01 * (x * x + y * y)});
  }
  return points;
}

TriangleMesh surface_of_scan(const std::vector<Point>& points) {
  return reconstruct_cocone(points, open_cloud_defaults()).mesh;
}

TEST(ScanRows, AreToldFromEvenAndFromRandomSamples) {
  for (const double across : {0.0, 0.1, 0.3}) {
    EXPECT_FALSE(lies_in_rows(surface_of_scan(rows(1, across)))) << across;
    EXPECT_FALSE(lies_in_rows(surface_of_scan(rows(2, across)))) << across;
    EXPECT_TRUE(lies_in_rows(surface_of_scan(rows(5, across)))) << across;
    EXPECT_TRUE(lies_in_rows(surface_of_scan(rows(10, across)))) << across;
  }
  EXPECT_FALSE(lies_in_rows(surface_of_scan(random_sheet(3000))));
  std::vector<Point> twice = rows(1, 0.2, 1);
  for (const Point& p : rows(1, 0.2, 2)) twice.push_back(p + Vec3{0.3, 0.4, 0});
  EXPECT_FALSE(lies_in_rows(surface_of_scan(twice)));
  EXPECT_FALSE(lies_in_rows(surface_of_scan(rows(10, 0)), {.min_ratio = 0}));
  EXPECT_FALSE(lies_in_rows({}));
}

TEST(ScanRows, AFourthOfTheTrianglesIsEnough) {
  TriangleMesh mesh;
  const auto add = [&](double along) {
    const VertexId first = mesh.points.push_back({0, 0, 0});
    mesh.points.push_back({along, 0, 0});
    mesh.points.push_back({along / 2, 1, 0});
    mesh.triangles.push_back({first, VertexId(first.index() + 1), VertexId(first.index() + 2)});
  };
  add(0.3);
  for (int i = 0; i < 3; ++i) add(1);
  EXPECT_TRUE(lies_in_rows(mesh));
  add(0);  // two corners are equal: counts for nothing
  EXPECT_TRUE(lies_in_rows(mesh));
  add(1);
  EXPECT_FALSE(lies_in_rows(mesh));
}

// The distance of rows is 1 everywhere: so none of those kept is closer than a half to another, and
// each of those left out is.
TEST(ScanRows, ThinnedSamplesAreApartAndCoverTheOthers) {
  std::vector<Point> cloud = rows(8, 0.1);
  const std::vector<Point> once = cloud;
  cloud.insert(cloud.end(), once.begin(), once.begin() + 100);  // equal ones
  const ReconstructResult scan = reconstruct_cocone(once, open_cloud_defaults());
  const std::vector<PointId> kept = thin_out_rows(cloud, scan.mesh, scan.point_of_vertex);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_LT(4 * kept.size(), once.size() * 2);
  const auto nearest_kept = [&](std::size_t k) {
    double nearest = 1e9;
    for (const PointId p : kept) {
      if (p.index() != k) nearest = std::min(nearest, distance(cloud[p.index()], cloud[k]));
    }
    return nearest;
  };
  std::size_t next = 0;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    const bool is_kept = next < kept.size() && kept[next].index() == k;
    next += is_kept ? 1U : 0U;
    if (is_kept) {
      EXPECT_LT(k, once.size());  // the first of equal ones
      EXPECT_GT(nearest_kept(k), 0.45);
    } else {
      EXPECT_LT(nearest_kept(k), 0.75);
    }
  }
}

TEST(ScanRows, ThinningIsAFunctionOfTheSetOfPoints) {
  const std::vector<Point> cloud = rows(6, 0.1);
  std::vector<Point> turned = cloud;
  std::reverse(turned.begin(), turned.end());
  const auto thinned = [](const std::vector<Point>& points) {
    const ReconstructResult scan = reconstruct_cocone(points, open_cloud_defaults());
    std::set<Point> kept;
    for (const PointId p : thin_out_rows(points, scan.mesh, scan.point_of_vertex)) {
      kept.insert(points[p.index()]);
    }
    return kept;
  };
  EXPECT_TRUE(thinned(cloud) == thinned(turned));
}

// Along a row of ten samples to a unit the triangles from row to row are needles: without thinning
// they are trimmed or not made.
TEST(ScanRows, HaveARim) {
  for (const double ratio : {4.0, 7.0, 10.0}) {
    const std::vector<Point> cloud = rows(ratio, 0.1);
    const CloudSurface surface = cloud_surface(cloud);
    ASSERT_EQ(surface.status, CloudStatus::ok) << ratio;
    EXPECT_GT(2 * surface.set_aside, cloud.size());
    EXPECT_FALSE(surface.is_layered);
    ASSERT_EQ(surface.rim.loops.size(), 1U) << ratio;
    EXPECT_NEAR(surface.rim.loops[0].perimeter, 98, 8) << ratio;
    for (const VertexId v : surface.mesh.points.ids()) {
      EXPECT_EQ(surface.mesh.points[v], cloud[surface.point_of_vertex[v].index()]);
    }
  }
  EXPECT_EQ(cloud_surface(rows(1, 0.1)).set_aside, 0U);
}

// The plane's samples alone are kept: the one that stands out is close to another.
TEST(ScanRows, OnAPlaneButForOneSampleHaveARim) {
  std::vector<Point> cloud;
  for (int i = 0; i <= 12; ++i) {
    for (int k = 0; k <= 240; ++k) cloud.push_back({0.05 * k, double(i), 3});
  }
  cloud.push_back({6.05, 6.0001, 3.001});
  const CloudSurface surface = cloud_surface(cloud);
  ASSERT_EQ(surface.status, CloudStatus::ok);
  EXPECT_GT(2 * surface.set_aside, cloud.size());
  ASSERT_EQ(surface.rim.loops.size(), 1U);
  EXPECT_NEAR(surface.rim.loops[0].perimeter, 48, 3);
  for (const Point& p : surface.mesh.points) EXPECT_EQ(p.z, 3);
}

TEST(ScanRows, OfWhichOneLineIsLeftAreLookedAtAsTheyAre) {
  const std::vector<Point> cloud = rows(7, 0.1);
  CloudSurfaceOptions options;
  options.rows.spread = 40;
  options.density.min_ratio = options.layers.spread = 0;
  EXPECT_EQ(cloud_surface(cloud, options).set_aside, 0U);
}

}  // namespace
}  // namespace cocoon
