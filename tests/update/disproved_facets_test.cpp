#include "update/disproved_facets.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A block with its top at z = 6, and level sheets of samples, one apart, that face up or down.
struct Scene {
  TriangleMesh block = testing::block(20, 20, 6);
  ModelIndex model{block};
  std::vector<Point> samples;
  std::vector<Outward> outward;
  TriangleSet settled = TriangleSet(block.triangles.size(), 0);

  void add_sheet(double low, double high, double z, double up, bool is_presumed = false) {
    for (double x = low; x <= high; ++x) {
      for (double y = low; y <= high; ++y) {
        samples.push_back({x, y, z});
        outward.push_back({{0, 0, up}, {0, 0, is_presumed ? up : 0}});
      }
    }
  }
  std::vector<TriangleId> found(const DisprovedOptions& options = {}) const {
    return disproved_facets(model, {samples, 1}, outward, settled, options);
  }
  // How many are found in this square of the top; all others must be outside of the larger one.
  std::size_t found_on_top(double low, double high, const DisprovedOptions& options = {}) const {
    std::size_t count = 0;
    for (const TriangleId t : found(options)) {
      const Point c = model.centroid(t);
      const auto within = [&](double l, double h) {
        return l < c.x && c.x < h && l < c.y && c.y < h;
      };
      EXPECT_EQ(c.z, 6);
      EXPECT_TRUE(within(low - 1, high + 1)) << c.x << " " << c.y;
      count += within(low, high) ? 1U : 0U;
    }
    return count;
  }
};

// Also deeper than the middle of the block, where its lower side is closer.
TEST(DisprovedFacets, OverTheFloorOfAPocket) {
  for (const double floor : {4.4, 1.3}) {
    Scene scene;
    scene.add_sheet(6.3, 13.5, floor, 1);
    EXPECT_GE(scene.found_on_top(6, 14), 50U) << floor;
  }
}

// A floor deep below looks at the place of its mouth, not through the wall beside it.
TEST(DisprovedFacets, NotBehindTheWallBesideAFloor) {
  const auto at_sides = [](const Scene& scene, const DisprovedOptions& options) {
    const std::vector<TriangleId> found = scene.found(options);
    return std::count_if(found.begin(), found.end(),
                         [&](TriangleId t) { return scene.model.centroid(t).z < 5.9; });
  };
  Scene pocket;
  pocket.add_sheet(2.3, 17.5, 1.3, 1, true);
  EXPECT_EQ(at_sides(pocket, {}), 0);
  EXPECT_GT(at_sides(pocket, {.min_presumed_cosine = 0.7}), 50);
  EXPECT_GE(pocket.found_on_top(2, 18), 200U);
  // A slanted one looks to where it was seen from, not along its normal.
  for (Outward& o : pocket.outward) o.normal = unit(Vec3{1, 0, 1});
  EXPECT_EQ(at_sides(pocket, {}), 0);
  EXPECT_GE(pocket.found_on_top(2, 18), 200U);
  Scene seen;  // the walls would be known, too
  seen.add_sheet(2.3, 17.5, 1.3, 1);
  EXPECT_GT(at_sides(seen, {}), 50);
}

TEST(DisprovedFacets, UnderTheTopOfABoss) {
  Scene scene;
  scene.add_sheet(6.3, 13.5, 10, 1);
  EXPECT_GE(scene.found_on_top(6, 14), 50U);
  EXPECT_EQ(scene.found({.reach = 3.5}).size(), 0U);
}

TEST(DisprovedFacets, NotBySamplesNearTheModelNorByThoseThatFaceOtherWays) {
  Scene near;
  near.add_sheet(6.3, 13.5, 7.1, 1);
  EXPECT_EQ(near.found().size(), 0U);
  EXPECT_GE(near.found({.off_model = 1, .scanned = 0}).size(), 50U);
  Scene arch;  // its lower side
  arch.add_sheet(6.3, 13.5, 10, -1);
  EXPECT_EQ(arch.found().size(), 0U);
  Scene unknown;
  unknown.add_sheet(6.3, 13.5, 10, 0);
  EXPECT_EQ(unknown.found().size(), 0U);
}

TEST(DisprovedFacets, NotWhatWasScanned) {
  Scene scene;
  scene.add_sheet(6.3, 13.5, 4.4, 1);
  scene.add_sheet(2.3, 17.5, 6.1, 1);  // the pocket is under the top
  EXPECT_EQ(scene.found().size(), 0U);
}

// The floor of an undercut, whose ceiling was scanned, too.
TEST(DisprovedFacets, NotBehindAnotherSurface) {
  Scene scene;
  scene.add_sheet(6.3, 13.5, 1.5, 1);
  scene.add_sheet(6.3, 13.5, 3.5, -1);
  for (const TriangleId t : scene.found()) EXPECT_NE(scene.model.centroid(t).z, 6);
  const std::vector<TriangleId> through = scene.found({.shelter = 0});
  EXPECT_TRUE(std::any_of(through.begin(), through.end(),
                          [&](TriangleId t) { return scene.model.centroid(t).z == 6; }));
}

TEST(DisprovedFacets, AllAreAskedOnlyIfFewDisproveWhatIsNotSettled) {
  Scene scene;
  scene.add_sheet(6.3, 13.5, 10, 1);
  const std::vector<TriangleId> all = scene.found();
  EXPECT_EQ(scene.found({.apart = 0}), all);
  for (const TriangleId t : all) scene.settled[t] = 1;
  EXPECT_EQ(scene.found().size(), 0U);
  EXPECT_EQ(scene.found({.apart = 0}), all);
}

TEST(DisprovedFacets, TheOrderOfTheSamplesDoesNotMatter) {
  Scene scene;
  scene.add_sheet(6.3, 13.5, 10, 1);
  scene.add_sheet(3.3, 9.5, 3.2, 1);
  const std::vector<TriangleId> found = scene.found();
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  EXPECT_EQ(std::set(found.begin(), found.end()).size(), found.size());
  std::reverse(scene.samples.begin(), scene.samples.end());
  std::reverse(scene.outward.begin(), scene.outward.end());
  EXPECT_EQ(scene.found(), found);
}

TEST(DisprovedFacets, RefusesWhatDoesNotBelongTogether) {
  Scene scene;
  scene.add_sheet(6.3, 13.5, 10, 1);
  EXPECT_THROW(scene.found({.reach = -1}), InputError);
  EXPECT_THROW(scene.found({.min_cosine = 2}), InputError);
  EXPECT_THROW(scene.found({.min_presumed_cosine = 2}), InputError);
  scene.settled = TriangleSet(3, 0);
  EXPECT_THROW(scene.found(), InputError);
  scene.settled = TriangleSet(scene.block.triangles.size(), 0);
  scene.outward.pop_back();
  EXPECT_THROW(scene.found(), InputError);
}

// One for each sample that sees a facet, with the sides that these are on.
TEST(Disproofs, TellWhetherThereIsAirOrBody) {
  for (const bool is_air : {true, false}) {
    Scene scene;
    scene.add_sheet(6.3, 13.5, is_air ? 3.2 : 8.8, 1);
    const std::vector<Disproof> found = disproofs(scene.model, {scene.samples, 1}, scene.outward);
    EXPECT_GE(found.size(), scene.samples.size() / 2);
    std::vector<TriangleId> facets;
    for (const Disproof& d : found) {
      EXPECT_EQ(d.is_air, is_air);
      EXPECT_EQ(d.sample.z, is_air ? 3.2 : 8.8);
      EXPECT_EQ(scene.model.centroid(d.facet).z, 6);
      facets.push_back(d.facet);
    }
    make_set(facets);
    EXPECT_EQ(facets, scene.found());
  }
  const Scene scene;
  const std::vector<Outward> of_others(3);
  EXPECT_THROW(disproofs(scene.model, {scene.samples, 1}, of_others), InputError);
}

}  // namespace
}  // namespace cocoon
