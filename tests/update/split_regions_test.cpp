#include "update/split_regions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"
#include "update/regions/loop_sides.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;
using testing::vertex;

constexpr std::size_t plane_size = 30;

// Takes the cell at (ax, y) and the cell at (bx, y) out of the grid plane and joins the holes by a
// square tube that rises over the plane in half an ellipse. Its facets come last.
void add_handle(TriangleMesh& mesh, std::size_t ax, std::size_t bx, std::size_t y) {
  const auto corner = [](std::size_t i, std::size_t j) { return vertex(j * (plane_size + 1) + i); };
  const auto is_in_cell = [&](const Triangle& t, std::size_t x) {
    return std::all_of(t.begin(), t.end(), [&](VertexId v) {
      return v == corner(x, y) || v == corner(x + 1, y) || v == corner(x, y + 1) ||
             v == corner(x + 1, y + 1);
    });
  };
  IdVector<TriangleId, Triangle> left;
  for (const Triangle& t : mesh.triangles) {
    if (!is_in_cell(t, ax) && !is_in_cell(t, bx)) left.push_back(t);
  }
  mesh.triangles = left;

  const double radius = 0.5 * static_cast<double>(bx - ax);
  const double center = 0.5 + 0.5 * static_cast<double>(ax + bx);
  const std::size_t steps = 4 * (bx - ax);
  std::vector<VertexId> ring = {corner(ax, y), corner(ax + 1, y), corner(ax + 1, y + 1),
                                corner(ax, y + 1)};
  for (std::size_t i = 1; i <= steps; ++i) {
    std::vector<VertexId> next = {corner(bx + 1, y), corner(bx, y), corner(bx, y + 1),
                                  corner(bx + 1, y + 1)};
    for (std::size_t k = 0; k < 4 && i < steps; ++k) {
      const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps);
      const double r = radius + (k == 1 || k == 2 ? -0.5 : 0.5);
      next[k] = mesh.points.push_back({center - r * std::cos(angle), static_cast<double>(y + k / 2),
                                       0.5 * r * std::sin(angle)});
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t l = (k + 1) % 4;
      mesh.triangles.push_back({ring[k], ring[l], next[l]});
      mesh.triangles.push_back({ring[k], next[l], next[k]});
    }
    ring = next;
  }
}

// Two tunnels lead from inside the rim to outside it: at y = 14 and y = 16.
TriangleMesh plane_with_handles() {
  TriangleMesh mesh = testing::grid_plane(plane_size);
  add_handle(mesh, 14, 24, 14);
  add_handle(mesh, 15, 25, 16);
  return mesh;
}

constexpr double rim_radius = 6;
const Point rim_center = {15.1, 15.2, 0};

CloudRim plane_rim() { return rim_of({circle(60, rim_center, rim_radius)}); }

std::vector<Point> disk() {
  std::vector<Point> points;
  for (double x = -rim_radius; x <= rim_radius; x += 0.5) {
    for (double y = -rim_radius; y <= rim_radius; y += 0.5) {
      if (std::hypot(x, y) <= rim_radius) points.push_back(rim_center + Vec3{x, y, 0});
    }
  }
  return points;
}

struct Case {
  explicit Case(TriangleMesh a_mesh, CloudRim a_rim, std::vector<Point> cloud)
      : mesh(std::move(a_mesh)), model(mesh), rims{std::move(a_rim)}, clouds{std::move(cloud)} {
    const Border border = trace_border(model, rims[0], overlapping_facets(model, rims[0]));
    regions = segment_model(mesh, border.facets);
    separation = loop_sides(mesh, model.neighbors(), border.loops.at(0), regions).separation;
  }
  RegionSplit split(const SplitOptions& options = {}, RegionId region = RegionId(0)) const {
    return split_regions(model, regions, std::vector<RegionId>{region}, rims, clouds, options);
  }
  TriangleMesh mesh;
  ModelIndex model;
  std::vector<CloudRim> rims;
  std::vector<std::vector<Point>> clouds;
  Regions regions;
  Separation separation = Separation::separates;
};

TEST(SplitRegions, CutsTheHandlesAcrossARim) {
  const Case plane(plane_with_handles(), plane_rim(), disk());
  ASSERT_EQ(plane.separation, Separation::non_separating);
  ASSERT_EQ(plane.regions.regions.size(), 1U);
  const RegionSplit split = plane.split();
  ASSERT_EQ(split.status, SplitStatus::ok);
  ASSERT_EQ(split.split.size(), 1U);
  ASSERT_EQ(split.regions.regions.size(), 2U);
  const SplitRegion& part = split.split[0];
  EXPECT_EQ(part.outside, RegionId(0));
  EXPECT_EQ(part.under, RegionId(1));
  EXPECT_EQ(part.under_facets, split.regions.regions[part.under].facets);

  // On the plane the rim is the limit. The tunnels, 12 long, have their inner mouths 4 to 5 from
  // the seeds and their outer ones 2: they are cut 4 to 6 from the inner mouth.
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    const RegionId region = split.regions.region_of_facet[t];
    if (region.is_none()) continue;
    const Point p = plane.model.centroid(t);
    if (p.z == 0) {
      const double r = std::hypot(p.x - rim_center.x, p.y - rim_center.y);
      EXPECT_EQ(region == part.under, r < rim_radius) << p.x << ' ' << p.y;
    } else if (p.x < 17 || p.x > 22) {
      EXPECT_EQ(region == part.under, p.x < 17) << p.x << ' ' << p.z;
    }
  }
  // Around a square tube the cut has a few edges for each side.
  EXPECT_GE(part.cut_edges, 2 * 4U);
  EXPECT_LE(part.cut_edges, 2 * 12U);
}

TEST(SplitRegions, GroupsAndCountsFollowTheLabels) {
  const Case plane(plane_with_handles(), plane_rim(), disk());
  const Regions regions = plane.split().regions;
  std::size_t facets = regions.border_facets;
  std::size_t vertices = regions.border_vertices;
  for (const Region& region : regions.regions) {
    facets += region.facets;
    vertices += region.vertices;
  }
  EXPECT_EQ(facets, plane.mesh.triangles.size());
  EXPECT_EQ(vertices, plane.mesh.points.size());
  EXPECT_EQ(regions.border_facets, plane.regions.border_facets);
  EXPECT_GT(regions.border_vertices, plane.regions.border_vertices);  // those of the cuts
  for (const RegionId r : regions.regions.ids()) {
    EXPECT_EQ(regions.region_of_facet[regions.regions[r].first], r);
  }
}

// The order of facets and scaling by a power of two change nothing.
TEST(SplitRegions, DependsOnTheShapeOnly) {
  const Case plane(plane_with_handles(), plane_rim(), disk());
  const RegionSplit split = plane.split();

  auto [other, order] = testing::shuffled(plane.mesh);
  for (Point& p : other.points) p = 1024 * p;
  std::vector<Point> cloud = disk();
  for (Point& p : cloud) p = 1024 * p;
  const Case moved(std::move(other), scaled(plane_rim(), 1024), std::move(cloud));
  const RegionSplit again = moved.split();
  ASSERT_EQ(again.status, SplitStatus::ok);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(again.regions.region_of_facet[TriangleId(i)],
              split.regions.region_of_facet[order[i]]);
  }
  EXPECT_EQ(again.split[0].cut_edges, split.split[0].cut_edges);
  EXPECT_EQ(again.split[0].reach, split.split[0].reach);
}

// Nothing but the rim: a region with facets near it on one side only has nothing to be split by.
TEST(SplitRegions, OneSidedRegionsAreNotSplit) {
  const Case plane(testing::grid_plane(plane_size), plane_rim(), disk());
  ASSERT_EQ(plane.regions.regions.size(), 2U);
  for (const RegionId r : plane.regions.regions.ids()) {
    const RegionSplit split = plane.split({}, r);
    EXPECT_EQ(split.status, SplitStatus::one_sided);
    EXPECT_NE(split.split[0].under_seeds == 0, split.split[0].outside_seeds == 0);
  }
  const Case handles(plane_with_handles(), plane_rim(), disk());
  EXPECT_EQ(handles.split({.seed_reach = 0}).status, SplitStatus::one_sided);
}

// A bowl across the tube of a torus: what is nearest to its inner side is half of the torus.
TEST(SplitRegions, APartFarFromTheCloudIsNotUnderIt) {
  constexpr double tube = 0.3;
  constexpr std::size_t n = 40;
  std::vector<Point> points;
  std::vector<Point> bowl;
  for (std::size_t j = 0; j < n; ++j) {
    const double v = 2 * std::numbers::pi * (static_cast<double>(j) + 0.3) / n;
    points.push_back(testing::torus_point(0.31, v, tube));
    for (const double r : {0.25, 0.5, 0.75, 1.0}) {
      bowl.push_back(testing::torus_point(0.31 + 0.3 * (1 - r * r), v, tube * r));
    }
  }
  std::vector<Vec3> normals;
  for (const Point& p : points) normals.push_back(unit(p - testing::torus_point(0.31, 0, 0)));
  const RimLoop rim = testing::loop_towards(points, normals, testing::torus_point(0.61, 0, 0));
  const Case membrane(testing::torus(60, 24, tube), rim_of({rim}), bowl);
  ASSERT_EQ(membrane.separation, Separation::non_separating);
  const RegionSplit split = membrane.split();
  EXPECT_EQ(split.status, SplitStatus::too_far);
  EXPECT_GT(split.split[0].reach, 1);
  // It is that bound that tells: half of the torus would be labeled.
  const RegionSplit half = membrane.split({.max_reach = 10});
  ASSERT_EQ(half.status, SplitStatus::ok);
  EXPECT_NEAR(static_cast<double>(half.regions.regions[RegionId(1)].facets), 60 * 24, 60 * 24 / 5);
}

}  // namespace
}  // namespace cocoon
