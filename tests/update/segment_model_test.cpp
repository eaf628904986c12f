#include "update/segment_model.h"

#include <cmath>
#include <gtest/gtest.h>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// The facets of the column of cells x in [column, column + 1].
TriangleSet column_border(const TriangleMesh& mesh, double column) {
  TriangleSet border(mesh.triangles.size(), 0);
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double x = (mesh.points[a].x + mesh.points[b].x + mesh.points[c].x) / 3;
    if (column < x && x < column + 1) border[t] = 1;
  }
  return border;
}

TEST(SegmentModel, ABandCutsThePlaneInTwo) {
  const TriangleMesh mesh = testing::grid_plane(10);
  const Regions regions = segment_model(mesh, column_border(mesh, 3));
  ASSERT_EQ(regions.regions.size(), 2U);
  EXPECT_EQ(regions.regions[RegionId(0)].facets, 60U);
  EXPECT_EQ(regions.regions[RegionId(1)].facets, 120U);
  EXPECT_EQ(regions.border_facets, 20U);
  // The band is one cell wide: each of its vertices is a corner of one region's facets only.
  EXPECT_EQ(regions.regions[RegionId(0)].vertices, 4U * 11);
  EXPECT_EQ(regions.regions[RegionId(1)].vertices, 7U * 11);
  EXPECT_EQ(regions.border_vertices, 0U);
  for (const VertexId v : mesh.points.ids()) {
    EXPECT_EQ(regions.group_of_vertex[v], RegionId(mesh.points[v].x <= 3 ? 0 : 1));
  }
}

TEST(SegmentModel, BorderVerticesHaveNoGroup) {
  const TriangleMesh mesh = testing::grid_plane(10);
  TriangleSet border = column_border(mesh, 3);
  const TriangleSet second = column_border(mesh, 4);
  for (const TriangleId t : border.ids()) border[t] |= second[t];
  const Regions regions = segment_model(mesh, border);
  EXPECT_EQ(regions.border_vertices, 11U);  // x = 4: all facets are in the border
  for (const VertexId v : mesh.points.ids()) {
    EXPECT_EQ(regions.group_of_vertex[v].is_none(), mesh.points[v].x == 4);
  }
}

TEST(SegmentModel, TinyIslandsJoinTheBorder) {
  const TriangleMesh mesh = testing::grid_plane(10);
  TriangleSet border = column_border(mesh, 3);
  const TriangleSet second = column_border(mesh, 4);
  for (const TriangleId t : border.ids()) border[t] |= second[t];
  // Two facets in the middle of the band, on both sides of x = 4, are free.
  for (const std::uint32_t t : {46U, 49U}) border[TriangleId(t)] = 0;
  const Regions merged = segment_model(mesh, border);
  EXPECT_EQ(merged.regions.size(), 2U);
  EXPECT_EQ(merged.merged_islands, 1U);
  EXPECT_EQ(merged.border_facets, 40U);
  const Regions all = segment_model(mesh, border, {.min_region_facets = 1});
  EXPECT_EQ(all.regions.size(), 3U);
  EXPECT_EQ(all.border_facets, 38U);
  // One of just that size is not tiny.
  const Regions one = segment_model(mesh, border, {.min_region_facets = 100});
  ASSERT_EQ(one.regions.size(), 1U);
  EXPECT_EQ(one.regions[RegionId(0)].facets, 100U);
  EXPECT_EQ(one.merged_islands, 2U);
}

TEST(SegmentModel, NothingIsMergedIfAllRegionsAreTiny) {
  const TriangleMesh mesh = testing::sphere(0);  // an octahedron
  TriangleSet border(8, 0);
  for (const std::uint32_t t : {0U, 2U, 5U, 7U}) border[TriangleId(t)] = 1;
  const Regions regions = segment_model(mesh, border);
  EXPECT_EQ(regions.merged_islands, 0U);
  std::size_t facets = 0;
  for (const Region& region : regions.regions) facets += region.facets;
  EXPECT_EQ(facets, 4U);
}

TEST(SegmentModel, NoBorderIsOneRegion) {
  const TriangleMesh mesh = testing::torus(12, 8, 0.3);
  const Regions regions = segment_model(mesh, TriangleSet(mesh.triangles.size(), 0));
  ASSERT_EQ(regions.regions.size(), 1U);
  EXPECT_EQ(regions.regions[RegionId(0)].vertices, 96U);
  EXPECT_EQ(regions.border_vertices, 0U);
}

TEST(SegmentModel, EverythingBorder) {
  const TriangleMesh mesh = testing::sphere(1);
  const Regions regions = segment_model(mesh, TriangleSet(mesh.triangles.size(), 1));
  EXPECT_TRUE(regions.regions.empty());
  EXPECT_EQ(regions.border_vertices, mesh.points.size());
}

TEST(SegmentModel, VerticesOfSeveralRegionsAndOfNoTriangleHaveNoGroup) {
  TriangleMesh mesh = gallery::two_tetrahedra_sharing_a_vertex();
  mesh.points.push_back({5, 5, 5});
  const Regions regions = segment_model(mesh, TriangleSet(8, 0));
  ASSERT_EQ(regions.regions.size(), 2U);
  for (const VertexId v : mesh.points.ids()) {
    const bool none = v == VertexId(0) || v == VertexId(7);
    EXPECT_EQ(regions.group_of_vertex[v].is_none(), none) << v.value;
  }
  EXPECT_EQ(regions.border_vertices, 1U);
}

// A ball cut in two with no border between the halves.
TEST(SegmentModel, RegionsThatTouchAreCountedAnew) {
  const TriangleMesh mesh = gallery::sphere(3);
  const ModelIndex model = ModelIndex::of_smooth(mesh);
  Regions regions = segment_model(model, TriangleSet(mesh.triangles.size(), 0));
  const RegionId upper = regions.regions.push_back({});
  for (const TriangleId t : mesh.triangles.ids()) {
    if (model.centroid(t).z > 0) regions.region_of_facet.set(t, upper);
  }
  count_and_group(model, regions);
  std::vector<std::size_t> facets(2, 0);
  std::vector<TriangleId> first(2);
  for (const TriangleId t : mesh.triangles.ids()) {
    const RegionId r = regions.region_of_facet[t];
    if (facets[r.index()]++ == 0) first[r.index()] = t;
  }
  std::size_t at_seam = 0;
  for (const VertexId v : mesh.points.ids()) {
    bool lower = false;
    bool higher = false;
    for (const TriangleId t : model.triangles_at(v)) {
      (regions.region_of_facet[t] == upper ? higher : lower) = true;
    }
    EXPECT_EQ(regions.group_of_vertex[v], lower && higher ? RegionId()
                                          : higher        ? upper
                                                          : RegionId(0U));
    at_seam += lower && higher ? 1U : 0U;
  }
  EXPECT_GT(at_seam, 10U);
  EXPECT_EQ(regions.border_vertices, at_seam);
  for (const RegionId r : regions.regions.ids()) {
    EXPECT_EQ(regions.regions[r].facets, facets[r.index()]);
    EXPECT_EQ(regions.regions[r].first, first[r.index()]);
  }
}

// Where the index knows that the facets at each vertex are one fan, fewer of them are looked at.
TEST(SegmentModel, IsTheSameWhateverTheIndexKnows) {
  Random random(7);
  const TriangleMesh mesh = gallery::sphere(4);
  const ModelIndex plain(mesh);
  const ModelIndex smooth = ModelIndex::of_smooth(mesh);
  std::size_t border_vertices = 0;
  for (int round = 0; round < 20; ++round) {
    TriangleSet border(mesh.triangles.size(), 0);
    for (int planes = 0; planes < 3; ++planes) {
      const Vec3 normal = random.on_unit_sphere();
      const double offset = random.uniform(-0.8, 0.8);
      const double width = random.uniform(0, 0.2);
      for (const TriangleId t : border.ids()) {
        const double height = dot(plain.centroid(t), normal) - offset;
        if (std::abs(height) < width) border[t] = 1;
      }
    }
    const Regions expected = segment_model(plain, border);
    const Regions regions = segment_model(smooth, border);
    ASSERT_EQ(regions.regions.size(), expected.regions.size());
    for (const RegionId r : expected.regions.ids()) {
      EXPECT_EQ(regions.regions[r].vertices, expected.regions[r].vertices);
    }
    EXPECT_EQ(regions.border_vertices, expected.border_vertices);
    EXPECT_TRUE(regions.region_of_facet == expected.region_of_facet);
    EXPECT_TRUE(regions.group_of_vertex == expected.group_of_vertex);
    border_vertices += expected.border_vertices;
  }
  EXPECT_GT(border_vertices, 100U);
}

TEST(SegmentModel, ABorderOfAnotherModelIsRefused) {
  const TriangleMesh mesh = testing::grid_plane(10);
  EXPECT_THROW(segment_model(mesh, column_border(testing::grid_plane(9), 3)), InputError);
  EXPECT_THROW(segment_model(mesh, TriangleSet()), InputError);
}

}  // namespace
}  // namespace cocoon
