#include "update/regions/unchanged_rest.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// The vertices (x, y, 0) of a plane, 0 to 12 each, of which those from x = 4 on were removed but
// for two, and samples over what lies before x = 7: at each vertex but one, beside one that stays.
// The other one hangs on what lies behind the samples.
struct PlaneBesideSamples {
  TriangleMesh mesh = testing::grid_plane(12);
  ModelIndex model{mesh};
  std::vector<VertexId> removed;
  std::vector<Point> samples;
  Regions regions;  // one for what was removed, and one for the rest
  RegionChoice choice;
  std::vector<RegionId> said_to_go;
  Point left_out{5, 6, 0};
  Point beside{5, 7, 0};
  Point behind{12, 12, 0};

  PlaneBesideSamples() {
    for (const VertexId v : mesh.points.ids()) {
      const Point& p = mesh.points[v];
      const bool stays = p.x < 4 || p == beside || p == behind;
      if (!stays) removed.push_back(v);
      regions.group_of_vertex.push_back(RegionId(stays ? 1U : 0U));
      if (p.x < 7 && p != left_out) samples.push_back(p);
    }
    regions.region_of_facet =
        SparseVector<TriangleId, RegionId>(mesh.triangles.size(), RegionId(0));
    regions.regions.resize(2);
    choice.replaced = IdVector<RegionId, std::uint8_t>(2, 1);
    choice.replaced[RegionId(1)] = 0;
  }
  std::vector<Point> rest(const UnchangedRestOptions& options = {}) const {
    const std::vector<NearestPointTree> trees(1, NearestPointTree(samples));
    std::vector<Point> points;
    const std::vector<Scan> scans = {{samples, 1, {}}};
    for (const VertexId v :
         unchanged_rest(model, removed, regions, choice, said_to_go, scans, trees, options)) {
      points.push_back(mesh.points[v]);
    }
    return points;
  }
};

// Of the two pieces that nobody scanned one reaches far from all samples.
TEST(UnchangedRest, IsOfPiecesThatHaveSamplesAllAround) {
  const PlaneBesideSamples plane;
  EXPECT_EQ(plane.rest(), std::vector<Point>{plane.left_out});
}

TEST(UnchangedRest, ReachesAsFarAsSamplesSpeakForIt) {
  const PlaneBesideSamples plane;
  const std::vector<Point> rest = plane.rest({.around = 6});
  EXPECT_EQ(rest.size(), 1U + 6U * 13U - 1U);  // from x = 7 on
  for (const Point& p : rest) EXPECT_TRUE(p.x >= 7 || p == plane.left_out);
}

TEST(UnchangedRest, HangsOnWhatStays) {
  PlaneBesideSamples plane;
  plane.removed.push_back(testing::nearest_vertex(plane.mesh, plane.beside));
  std::sort(plane.removed.begin(), plane.removed.end());
  EXPECT_TRUE(plane.rest().empty());
}

// One between is enough, two are not.
TEST(UnchangedRest, AVertexThatStaysAmidWhatGoesIsNothingToHangOn) {
  PlaneBesideSamples plane;
  const VertexId beside = testing::nearest_vertex(plane.mesh, plane.beside);
  plane.regions.group_of_vertex.set(beside, RegionId());
  EXPECT_TRUE(plane.rest().empty());
  const VertexId next = testing::nearest_vertex(plane.mesh, {5, 8, 0});
  plane.regions.group_of_vertex.set(next, RegionId(1));
  EXPECT_EQ(plane.rest().size(), 1U);
}

TEST(UnchangedRest, IsNoneWhereASampleNearbyShowsAChange) {
  PlaneBesideSamples plane;
  plane.samples.push_back({5, 3.5, 0.3});
  EXPECT_EQ(plane.rest().size(), 1U);
  plane.samples.back().z = 0.5;
  EXPECT_TRUE(plane.rest().empty());
  plane.samples.back().y = 2.5;  // farther than 3
  EXPECT_EQ(plane.rest().size(), 1U);
}

TEST(UnchangedRest, IsNotWhatWasScannedAgain) {
  PlaneBesideSamples plane;
  plane.samples.push_back(plane.left_out + Vec3{0.5, 0.5, 0.2});
  EXPECT_TRUE(plane.rest().empty());
  EXPECT_EQ(plane.rest({.reach = 0.7}).size(), 1U);
}

TEST(UnchangedRest, IsNotWhatIsSaidToGo) {
  PlaneBesideSamples plane;
  plane.said_to_go = {RegionId(1)};
  EXPECT_EQ(plane.rest().size(), 1U);
  plane.said_to_go = {RegionId(0)};
  EXPECT_TRUE(plane.rest().empty());
}

TEST(UnchangedRest, CanBeSwitchedOff) {
  EXPECT_TRUE(PlaneBesideSamples().rest({.reach = 0}).empty());
}

TEST(UnchangedRest, SamplesOutOfRegisterAreMovedBack) {
  PlaneBesideSamples plane;
  const Vec3 shift{0, 0, 0.6};
  for (Point& p : plane.samples) p = p + shift;
  EXPECT_TRUE(plane.rest().empty());
  const std::vector<NearestPointTree> trees(1, NearestPointTree(plane.samples));
  const std::vector<Scan> scans = {{plane.samples, 1, shift}};
  EXPECT_EQ(
      unchanged_rest(plane.model, plane.removed, plane.regions, plane.choice, {}, scans, trees)
          .size(),
      1U);
}

TEST(UnchangedRest, EachScanNeedsATree) {
  const PlaneBesideSamples plane;
  const std::vector<Scan> scans = {{plane.samples, 1, {}}};
  EXPECT_THROW(
      unchanged_rest(plane.model, plane.removed, plane.regions, plane.choice, {}, scans, {}),
      InputError);
  const std::vector<NearestPointTree> trees(1, NearestPointTree(plane.samples));
  EXPECT_THROW(unchanged_rest(plane.model, plane.removed, plane.regions, plane.choice, {}, scans,
                              trees, {.around = -1}),
               InputError);
}

}  // namespace
}  // namespace cocoon
