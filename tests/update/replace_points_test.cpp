#include "update/replace_points.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/replaced_disk.h"

namespace cocoon {
namespace {

using testing::ReplacedDisk;

TEST(ReplacePoints, KeptVerticesComeFirstInOrderWithTheirBits) {
  const ReplacedDisk scene;
  const Replacement result = scene.replace();
  PointId last;
  for (const VertexId v : scene.model.points.ids()) {
    const PointId p = result.point_of_vertex[v];
    if (p.is_none()) continue;
    EXPECT_EQ(result.points[p.index()], scene.model.points[v]);
    EXPECT_TRUE(last.is_none() || last < p);
    last = p;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const PointId p = result.point_of_cloud_point[0][PointId(i)];
    EXPECT_EQ(p.index(), result.vertices.kept + i);
    EXPECT_EQ(result.points[p.index()], scene.clouds[0][i]);
  }
}

TEST(ReplacePoints, EqualPointsAreMerged) {
  ReplacedDisk scene;
  scene.clouds[0].push_back({0, 0, 0});    // a kept vertex
  scene.clouds[0].push_back({10, 10, 2});  // a cloud point
  scene.clouds.push_back({{11, 10, 2}, {0, 20, -0.0}});
  scene.rims.push_back({});
  const Replacement result = scene.replace();
  EXPECT_EQ(result.duplicates, 4U);
  EXPECT_EQ(result.points.size(), result.vertices.kept + 3);
  EXPECT_EQ(result.point_of_cloud_point[0][PointId(3)], result.point_of_vertex[VertexId(0)]);
  EXPECT_EQ(result.point_of_cloud_point[0][PointId(4)], result.point_of_cloud_point[0][PointId(0)]);
  EXPECT_EQ(result.point_of_cloud_point[1][PointId(0)], result.point_of_cloud_point[0][PointId(1)]);
  EXPECT_TRUE(result.kept_are_distinct);
  const VertexId at_corner = scene.model.points.push_back({0, 0, 0});
  scene.model.triangles.push_back({at_corner, VertexId(1), VertexId(21)});
  scene.regions.group_of_vertex.push_back(scene.regions.group_of_vertex[VertexId(0)]);
  scene.regions.region_of_facet.push_back(scene.regions.region_of_facet[TriangleId(0)]);
  const Replacement merged = scene.replace();
  EXPECT_EQ(merged.point_of_vertex[at_corner], merged.point_of_vertex[VertexId(0)]);
  EXPECT_FALSE(merged.kept_are_distinct);
}

TEST(ReplacePoints, SamplesWithAFlagAreLeftOut) {
  ReplacedDisk scene;
  scene.clouds.push_back({{11, 10, 2}, {12, 10, 2}});
  const ModelIndex index(scene.model);
  const ReplacedVertices replaced = replaced_vertices(index, scene.regions, scene.choice,
                                                      scene.rims, {scene.clouds.data(), 1}, {});
  std::vector<SampleFlags> left_out = {SampleFlags(std::vector<std::uint8_t>{0, 1, 0}),
                                       SampleFlags(std::vector<std::uint8_t>{0, 0})};
  const Replacement result = replace_points(index, replaced, scene.clouds, left_out);
  EXPECT_EQ(result.left_out, 1U);
  EXPECT_EQ(result.duplicates, 0U);  // the first of the two at one place is not there
  ASSERT_EQ(result.points.size(), result.vertices.kept + 4);
  EXPECT_TRUE(result.point_of_cloud_point[0][PointId(1)].is_none());
  for (std::size_t c = 0; c < 2; ++c) {
    for (const PointId p : result.point_of_cloud_point[c].ids()) {
      const PointId at = result.point_of_cloud_point[c][p];
      if (at.is_none()) continue;
      EXPECT_EQ(result.points[at.index()], scene.clouds[c][p.index()]);
    }
  }
  EXPECT_EQ(replace_points(index, replaced, scene.clouds).left_out, 0U);
  left_out[1] = SampleFlags(3, 0);
  EXPECT_THROW(replace_points(index, replaced, scene.clouds, left_out), InputError);
  left_out.pop_back();
  EXPECT_THROW(replace_points(index, replaced, scene.clouds, left_out), InputError);
}

// Equal vertices are one point even where no cloud is near them; and a sample that is equal to a
// vertex does not keep vertices from having points of their own, though it be the very first.
TEST(ReplacePoints, EqualVerticesAreMergedFarFromTheCloudsToo) {
  ReplacedDisk scene;
  scene.clouds[0].insert(scene.clouds[0].begin(), {20, 20, 0});
  EXPECT_EQ(scene.replace().duplicates, 1U);
  EXPECT_TRUE(scene.replace().kept_are_distinct);
  scene.clouds[0].erase(scene.clouds[0].begin());
  const VertexId at_corner = scene.model.points.push_back({0, 0, 0});
  scene.model.triangles.push_back({at_corner, VertexId(1), VertexId(21)});
  scene.regions.group_of_vertex.push_back(scene.regions.group_of_vertex[VertexId(0)]);
  scene.regions.region_of_facet.push_back(scene.regions.region_of_facet[TriangleId(0)]);
  const Replacement merged = scene.replace();
  EXPECT_EQ(merged.duplicates, 1U);
  EXPECT_EQ(merged.point_of_vertex[at_corner], merged.point_of_vertex[VertexId(0)]);
  EXPECT_FALSE(merged.kept_are_distinct);
}

TEST(ReplacePoints, TellsWhoWasRemoved) {
  const Replacement result = ReplacedDisk().replace();
  std::vector<VertexId> removed;
  for (const VertexId v : result.point_of_vertex.ids()) {
    if (result.point_of_vertex[v].is_none()) removed.push_back(v);
  }
  EXPECT_FALSE(removed.empty());
  EXPECT_EQ(result.vertices.removed, removed);
}

// Who goes may be said by hand; the numbers of vertices that stay are those of the list.
TEST(ReplacePoints, WhoGoesMayBeSaidByHand) {
  const ReplacedDisk scene;
  const ModelIndex index(scene.model);
  ReplacedVertices vertices;
  vertices.removed = {VertexId(1), VertexId(7)};
  const Replacement result = replace_points(index, vertices, scene.clouds);
  EXPECT_EQ(result.vertices.removed, vertices.removed);
  EXPECT_EQ(result.vertices.kept, scene.model.points.size() - 2);
  EXPECT_EQ(result.points.size(), result.vertices.kept + 3);
  EXPECT_EQ(result.point_of_vertex[VertexId(8)], PointId(6));
  vertices.removed = {VertexId(7), VertexId(1)};
  EXPECT_THROW(replace_points(index, vertices, scene.clouds), InputError);
  vertices.removed = {VertexId(scene.model.points.size())};
  EXPECT_THROW(replace_points(index, vertices, scene.clouds), InputError);
}

}  // namespace
}  // namespace cocoon
