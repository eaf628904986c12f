// Rims that are whole, but do not cut the model in two: handles lead from one side to the other.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"
#include "tests/update/torn_rims.h"
#include "update/cut_regions.h"
#include "update/regions/loop_sides.h"

namespace cocoon {
namespace {

using testing::middle;
using testing::radius;
using testing::RimOnAMesh;
using testing::torn_rim;
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

  const double arch = 0.5 * static_cast<double>(bx - ax);
  const double center = 0.5 + 0.5 * static_cast<double>(ax + bx);
  const std::size_t steps = 4 * (bx - ax);
  std::vector<VertexId> ring = {corner(ax, y), corner(ax + 1, y), corner(ax + 1, y + 1),
                                corner(ax, y + 1)};
  for (std::size_t i = 1; i <= steps; ++i) {
    std::vector<VertexId> next = {corner(bx + 1, y), corner(bx, y), corner(bx, y + 1),
                                  corner(bx + 1, y + 1)};
    for (std::size_t k = 0; k < 4 && i < steps; ++k) {
      const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps);
      const double r = arch + (k == 1 || k == 2 ? -0.5 : 0.5);
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

CutRegions regions_cut(const RimOnAMesh& plane) {
  const std::vector<std::size_t> joined = {0};
  const std::vector<std::uint8_t> is_cut = {1};
  const std::vector<Scan> scans(1);
  return cut_regions(
      plane.model, {std::span(&plane.rim, 1), std::span(&plane.border, 1), scans, joined, is_cut});
}

TEST(CutHandles, TheyAreCutWhereTheyAreNarrowest) {
  const RimOnAMesh plane(plane_with_handles(), torn_rim(0, 0));
  const Regions before = segment_model(plane.mesh, plane.border.facets);
  ASSERT_EQ(before.regions.size(), 1U);
  const auto separation_by = [&](const Regions& regions) {
    return loop_sides(plane.mesh, plane.model.neighbors(), plane.border.loops[0], regions)
        .separation;
  };
  EXPECT_EQ(separation_by(before), Separation::non_separating);

  const CutRegions cut = regions_cut(plane);
  EXPECT_EQ(separation_by(cut.regions), Separation::separates);
  ASSERT_EQ(cut.regions.regions.size(), 2U);
  EXPECT_EQ(cut.under[0].raw(), (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(cut.cuts[0].contradicted, 0);
  // On the plane the rim is the limit. The tunnels lead from x = 14 to 25, and at their tops their
  // facets are half as high.
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    const RegionId region = cut.regions.region_of_facet[t];
    if (region.is_none()) continue;
    const bool is_under = cut.under[0][region] != 0;
    const Point p = plane.model.centroid(t);
    if (p.z == 0) {
      EXPECT_EQ(is_under, plane.radius_of(t) < radius) << p.x << ' ' << p.y;
    } else if (p.x < 18.5 || p.x > 21.5) {
      EXPECT_EQ(is_under, p.x < 18.5) << p.x << ' ' << p.z;
    }
  }
  // Around each square tube.
  EXPECT_EQ(cut.cuts[0].cut_edges, 2 * 4U);
  EXPECT_LT(cut.cuts[0].doubt(), 0.3);
}

TEST(CutHandles, GroupsAndCountsFollowTheLabels) {
  const RimOnAMesh plane(plane_with_handles(), torn_rim(0, 0));
  const Regions regions = regions_cut(plane).regions;
  std::size_t facets = regions.border_facets;
  std::size_t vertices = regions.border_vertices;
  for (const Region& region : regions.regions) {
    facets += region.facets;
    vertices += region.vertices;
  }
  EXPECT_EQ(facets, plane.mesh.triangles.size());
  EXPECT_EQ(vertices, plane.mesh.points.size());
  const Regions before = segment_model(plane.mesh, plane.border.facets);
  EXPECT_EQ(regions.border_facets, before.border_facets);
  EXPECT_GT(regions.border_vertices, before.border_vertices);  // those of the cuts
  for (const RegionId r : regions.regions.ids()) {
    EXPECT_EQ(regions.region_of_facet[regions.regions[r].first], r);
  }
}

}  // namespace
}  // namespace cocoon
