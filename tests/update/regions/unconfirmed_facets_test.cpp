#include "update/regions/unconfirmed_facets.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane of unit squares, of which the part left of 10 was scanned where it is, that up to 20 as
// if it were 1.5 higher, and the rest not.
struct PartlyScanned {
  TriangleMesh mesh = testing::grid_plane(40);
  ModelIndex model{mesh};
  std::vector<Point> on_it;
  std::vector<Point> above;
  std::vector<TriangleId> all;

  PartlyScanned() {
    for (double x = 0.25; x < 20; x += 0.5) {
      for (double y = 0.25; y < 40; y += 0.5) {
        (x < 10 ? on_it : above).push_back({x, y, x < 10 ? 0.1 : 1.5});
      }
    }
    for (const TriangleId t : mesh.triangles.ids()) all.push_back(t);
  }
  TriangleSet found(const std::vector<Scan>& scans, const UnconfirmedOptions& options = {}) const {
    return unconfirmed_facets(model, scans, all, options);
  }
};

TEST(UnconfirmedFacets, AreThoseBesideWhichSamplesLie) {
  const PartlyScanned plane;
  const TriangleSet found = plane.found({{plane.on_it, 1}, {plane.above, 1}});
  for (const TriangleId t : plane.all) {
    const double x = plane.model.centroid(t).x;
    if (x < 9.5 || x > 23) {
      EXPECT_EQ(found[t], 0) << x;
    }
    if (x > 11 && x < 21.5) {
      EXPECT_EQ(found[t], 1) << x;
    }
  }
  const TriangleSet loose =
      plane.found({{plane.on_it, 1}, {plane.above, 1}}, {.reach = 2, .height = 1.6});
  for (const TriangleId t : plane.all) {
    if (plane.model.centroid(t).x < 20) {
      EXPECT_EQ(loose[t], 0);
    }
  }
}

TEST(UnconfirmedFacets, SamplesAreLookedAtWhereTheyBelong) {
  const PartlyScanned plane;
  const TriangleSet found = plane.found({{plane.above, 1, {0, 0, 1.5}}});
  for (const TriangleId t : plane.all) {
    const double x = plane.model.centroid(t).x;
    if (x > 10 && x < 20) {
      EXPECT_EQ(found[t], 0) << x;
    }
  }
}

TEST(UnconfirmedFacets, OnlyThoseAskedForAreTold) {
  const PartlyScanned plane;
  const Scan scan{plane.above, 1};
  const std::vector<TriangleId> none;
  EXPECT_TRUE(members(unconfirmed_facets(plane.model, std::span(&scan, 1), none)).empty());
  EXPECT_TRUE(members(plane.found({})).empty());
  EXPECT_TRUE(members(plane.found({Scan{}})).empty());
  EXPECT_THROW(plane.found({scan}, {.height = -1}), InputError);
}

}  // namespace
}  // namespace cocoon
