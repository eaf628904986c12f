#include "update/replaced_vertices.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/replaced_disk.h"

namespace cocoon {
namespace {

using testing::ReplacedDisk;

TEST(ReplacedVertices, RemovesWhatLiesInsideTheRimAndNothingElse) {
  const ReplacedDisk scene;
  const Replacement result = scene.replace();
  std::size_t inside = 0;
  for (const VertexId v : scene.model.points.ids()) {
    const bool under = distance(scene.model.points[v], {10, 10, 0}) < 6.3;
    inside += under ? 1 : 0;
    EXPECT_EQ(result.point_of_vertex[v].is_none(), under) << v.value;
  }
  EXPECT_EQ(result.vertices.replaced, inside);
  EXPECT_EQ(result.vertices.kept, scene.model.points.size() - inside);
  EXPECT_EQ(result.vertices.border_kept + result.vertices.border_replaced,
            scene.regions.border_vertices);
  EXPECT_EQ(result.points.size(), result.vertices.kept + 3);
  EXPECT_EQ(result.duplicates, 0U);
}

TEST(ReplacedVertices, UnusedVerticesAreNotCarriedOver) {
  ReplacedDisk scene;
  scene.model.points.push_back({100, 100, 100});
  scene.regions.group_of_vertex.push_back({});
  const Replacement result = scene.replace();
  EXPECT_EQ(result.vertices.unused_vertices, 1U);
  EXPECT_TRUE(result.point_of_vertex[VertexId(scene.model.points.size() - 1)].is_none());
}

TEST(ReplacedVertices, ThinningDropsKeptVerticesNearTheCloud) {
  ReplacedDisk scene;
  scene.clouds[0].push_back({2, 3.1, 0});
  EXPECT_EQ(scene.replace().vertices.thinned, 0U);
  const Replacement thinned = scene.replace({.thinning_distance = 0.5, .scanned = {.rim_zone = 0}});
  EXPECT_EQ(thinned.vertices.thinned, 1U);
  EXPECT_TRUE(thinned.point_of_vertex[VertexId(3 * 21 + 2)].is_none());
  // A cloud without points thins nothing.
  scene.clouds.emplace_back();
  scene.rims.push_back(scene.rims[0]);
  EXPECT_EQ(scene.replace({.thinning_distance = 0.5, .scanned = {.rim_zone = 0}}).vertices.thinned,
            1U);
}

// Closer than a share of the spacing of the cloud's own rim; as far as that is not closer.
TEST(ReplacedVertices, ThinningReachesAShareOfTheSpacingOfEachCloud) {
  ReplacedDisk scene;
  scene.clouds[0].push_back({2, 3.125, 0});
  const auto thinned = [&](double spacing) {
    scene.rims[0].spacing = spacing;
    return scene.replace({.thinning_distance = 0.5, .scanned = {.rim_zone = 0}}).vertices.thinned;
  };
  EXPECT_EQ(thinned(0.2), 0U);
  EXPECT_EQ(thinned(0.25), 0U);
  EXPECT_EQ(thinned(0.26), 1U);
}

TEST(ReplacedVertices, VerticesInTheBorderAreDecidedWhetherThinnedOrNot) {
  const TriangleMesh model = testing::grid_plane(10);
  const std::vector<CloudRim> rims = {testing::rim_of({testing::circle(24, {5, 5, 0.02}, 0.4)})};
  const std::vector<std::vector<Point>> clouds = {{{5, 5.2, 1}, {5.1, 5, 1}, {4.9, 5, 1}}};
  const ModelIndex index(model);
  const Border border = trace_border(index, rims[0], overlapping_facets(index, rims[0]));
  const Regions regions = segment_model(model, border.facets);
  ASSERT_EQ(regions.border_vertices, 1U);
  RegionChoice choice;
  choice.replaced = IdVector<RegionId, std::uint8_t>(regions.regions.size(), 0);
  for (const double thinning : {0.0, 0.5}) {
    const Replacement result =
        replace_points(index, regions, choice, rims, clouds, clouds,
                       {.thinning_distance = thinning, .scanned = {.rim_zone = 0}});
    EXPECT_EQ(result.vertices.border_replaced, 1U);
    EXPECT_EQ(result.vertices.border_kept, 0U);
  }
}

// At the very rim the samples tell: a vertex inside it without a sample stays, one outside with a
// sample goes; whatever is farther from it goes by its side.
TEST(ReplacedVertices, AtTheRimSamplesTell) {
  ReplacedDisk scene;
  const auto at = [](std::size_t x, std::size_t y) { return VertexId(y * 21 + x); };
  const VertexId inside = at(10, 16);   // 0.3 inside a rim of radius 6.3
  const VertexId outside = at(15, 14);  // 0.1 outside
  scene.clouds[0].push_back({15.1, 14.2, 0.1});
  const ReplaceOptions options{.scanned = {.rim_zone = 0.31, .sample_reach = 0.36}};
  const Replacement result = scene.replace(options);
  EXPECT_FALSE(result.point_of_vertex[inside].is_none());
  EXPECT_TRUE(result.point_of_vertex[outside].is_none());
  EXPECT_EQ(result.vertices.scanned_replaced, 1U);
  EXPECT_GT(result.vertices.unscanned_kept, 0U);
  EXPECT_EQ(result.vertices.replaced, scene.replace().vertices.replaced +
                                          result.vertices.scanned_replaced -
                                          result.vertices.unscanned_kept);
  for (const VertexId v : scene.model.points.ids()) {
    const double radius = distance(scene.model.points[v], {10, 10, 0});
    if (std::abs(radius - 6.3) < 0.4) continue;
    EXPECT_EQ(result.point_of_vertex[v].is_none(), radius < 6.3) << v.value;
  }
}

// Where no region goes there is nothing to replace: what lies before the rim stays for all samples.
TEST(ReplacedVertices, WhereNoRegionGoesNothingBeforeTheRimDoes) {
  ReplacedDisk scene;
  const VertexId outside(14 * 21 + 15);  // by 0.1
  scene.clouds[0].push_back({15.1, 14.2, 0.1});
  const ReplaceOptions options{.scanned = {.rim_zone = 0.31, .sample_reach = 0.36}};
  EXPECT_TRUE(scene.replace(options).point_of_vertex[outside].is_none());
  for (std::uint8_t& replaced : scene.choice.replaced) replaced = 0;
  const Replacement result = scene.replace(options);
  EXPECT_FALSE(result.point_of_vertex[outside].is_none());
  EXPECT_EQ(result.vertices.scanned_replaced, 0U);
}

// Parts the region of the vertex nearest to p by a line that is no border, and adds a rim around p
// that has got there by mistake.
void part_at(const Point& p, bool cloud_inside, ReplacedDisk& scene) {
  const VertexId at = testing::nearest_vertex(scene.model, p);
  const RegionId region = scene.regions.group_of_vertex[at];
  const RegionId part = scene.regions.regions.push_back({});
  scene.choice.replaced.push_back(scene.choice.replaced[region]);
  const ModelIndex index(scene.model);
  for (const TriangleId t : scene.model.triangles.ids()) {
    if (scene.regions.region_of_facet[t] != region || index.centroid(t).x < p.x) continue;
    scene.regions.region_of_facet.set(t, part);
  }
  count_and_group(index, scene.regions);
  ASSERT_TRUE(scene.regions.group_of_vertex[at].is_none());
  RimLoop stray = testing::circle(12, p, 1.5);
  for (std::size_t i = 0; i < stray.size(); ++i) {
    if (!cloud_inside) stray.apexes[i] = stray.points[i] + (stray.points[i] - p);
  }
  scene.rims[0].loops.push_back(stray);
}

// Where no border is, what lies between two regions goes if both go, and stays if both stay.
TEST(ReplacedVertices, BetweenRegionsOfOneMindNoRimTells) {
  const std::vector<VertexId> removed = ReplacedDisk().replace().vertices.removed;
  ReplacedDisk inside;
  part_at({10, 10, 0}, false, inside);
  EXPECT_EQ(inside.replace().vertices.removed, removed);
  ReplacedDisk outside;
  part_at({10, 1, 0}, true, outside);
  EXPECT_EQ(outside.replace().vertices.removed, removed);
}

// A vertex all of whose facets are border, and a loop around it that says it is outside the cloud.
void surround(const Point& p, bool is_partial, ReplacedDisk& scene) {
  const VertexId at = testing::nearest_vertex(scene.model, p);
  const ModelIndex index(scene.model);
  for (const TriangleId t : index.triangles_at(at)) {
    scene.regions.region_of_facet.set(t, RegionId());
  }
  count_and_group(index, scene.regions);
  RimLoop stray = testing::circle(12, p, 0.5);
  for (std::size_t i = 0; i < stray.size(); ++i) {
    stray.apexes[i] = stray.points[i] + (stray.points[i] - p);
  }
  stray.inner.assign(stray.size(), 0);
  if (is_partial) stray.inner[5] = 1;
  scene.rims[0].loops.push_back(stray);
}

// Beyond a whole loop the model may go on. One that is partial may lead around nothing: if all
// regions around go, so does what lies between them.
TEST(ReplacedVertices, InTheMidstOfWhatGoesNoPartialLoopTells) {
  const VertexId at = testing::nearest_vertex(ReplacedDisk().model, {10, 10, 0});
  ReplacedDisk partial;
  surround({10, 10, 0}, true, partial);
  const Replacement gone = partial.replace();
  EXPECT_TRUE(gone.point_of_vertex[at].is_none());
  EXPECT_EQ(gone.vertices.enclosed_replaced, 1U);
  EXPECT_EQ(gone.vertices.removed, ReplacedDisk().replace().vertices.removed);
  const Replacement off = partial.replace({.scanned = {.rim_zone = 0}, .enclosed_go = false});
  EXPECT_FALSE(off.point_of_vertex[at].is_none());
  EXPECT_EQ(off.vertices.enclosed_replaced, 0U);
  ReplacedDisk whole;
  surround({10, 10, 0}, false, whole);
  EXPECT_FALSE(whole.replace().point_of_vertex[at].is_none());
  // Among what stays it stays.
  ReplacedDisk outside;
  surround({10, 1, 0}, true, outside);
  EXPECT_EQ(outside.replace().vertices.removed, ReplacedDisk().replace().vertices.removed);
}

TEST(ReplacedVertices, InputsOfAnotherModelAreRefused) {
  ReplacedDisk scene;
  EXPECT_NO_THROW(scene.replace());
  scene.clouds.emplace_back();
  EXPECT_THROW(scene.replace(), InputError);  // fewer rims than clouds
  scene.clouds.pop_back();
  scene.choice.replaced = {};
  EXPECT_THROW(scene.replace(), InputError);
}

// Whatever their regions: one that goes anyway, one in the large region that stays.
TEST(ReplacedVertices, OverlookedVerticesGo) {
  const ReplacedDisk disk;
  const std::vector<VertexId> overlooked = {testing::nearest_vertex(disk.model, {1, 1, 0}),
                                            testing::nearest_vertex(disk.model, {10, 10, 0})};
  const Replacement before = disk.replace();
  const Replacement after = disk.replace({.scanned = {.rim_zone = 0}}, {.go = overlooked});
  EXPECT_EQ(before.vertices.overlooked, 0U);
  EXPECT_EQ(after.vertices.overlooked, 1U);
  EXPECT_EQ(after.vertices.replaced, before.vertices.replaced + 1);
  EXPECT_EQ(after.vertices.kept, before.vertices.kept - 1);
  EXPECT_FALSE(before.point_of_vertex[overlooked[0]].is_none());
  EXPECT_TRUE(after.point_of_vertex[overlooked[0]].is_none());
}

TEST(ReplacedVertices, VerticesThatAreSaidToStayStay) {
  const ReplacedDisk disk;
  const std::vector<VertexId> stay = {testing::nearest_vertex(disk.model, {1, 1, 0}),
                                      testing::nearest_vertex(disk.model, {10, 10, 0})};
  const Replacement before = disk.replace();
  const Replacement after = disk.replace({.scanned = {.rim_zone = 0}}, {.stay = stay});
  EXPECT_EQ(before.vertices.unchanged, 0U);
  EXPECT_EQ(after.vertices.unchanged, 1U);
  EXPECT_EQ(after.vertices.overlooked, 0U);
  EXPECT_EQ(after.vertices.replaced, before.vertices.replaced - 1);
  EXPECT_EQ(after.vertices.kept, before.vertices.kept + 1);
  EXPECT_TRUE(before.point_of_vertex[stay[1]].is_none());
  EXPECT_FALSE(after.point_of_vertex[stay[1]].is_none());
  const std::vector<VertexId> descending = {stay[1], stay[0]};
  EXPECT_THROW(disk.replace({}, {.stay = descending}), InputError);
}

}  // namespace
}  // namespace cocoon
