#include "update/regions/island_spread.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane with a border around a disk in its middle.
struct Island {
  TriangleMesh mesh = testing::grid_plane(20);
  ModelIndex model{mesh};
  TriangleSet border = TriangleSet(mesh.triangles.size(), 0);
  TriangleSet under = border;

  Island() {
    for (const TriangleId t : mesh.triangles.ids()) border[t] = radius(t) > 6 && radius(t) < 8;
  }

  double radius(TriangleId t) const {
    const Point c = model.centroid(t);
    return std::hypot(c.x - 10, c.y - 10);
  }
  std::vector<TriangleId> ring(double inner, double outer) const {
    std::vector<TriangleId> found;
    for (const TriangleId t : mesh.triangles.ids()) {
      if (radius(t) >= inner && radius(t) < outer) found.push_back(t);
    }
    return found;
  }
  std::vector<TriangleId> spread(std::vector<TriangleId> facets, double reach,
                                 double min_share) const {
    TriangleSet settled = border;
    for (const TriangleId t : settled.ids()) settled[t] |= under[t];
    spread_on_islands(model, settled, reach, min_share, facets);
    return facets;
  }
};

TEST(SpreadOnIslands, ToWhatIsNear) {
  const Island island;
  const std::vector<TriangleId> found = island.spread(island.ring(0, 4), 1.2, 0.15);
  for (const TriangleId t : found) EXPECT_LT(island.radius(t), 5.2);
  EXPECT_GT(found.size(), island.ring(0, 4.6).size());
  EXPECT_EQ(island.spread(island.ring(0, 4), 5, 0.15), island.ring(0, 6.0000001));
}

TEST(SpreadOnIslands, NotIfTheFacetsAreFew) {
  const Island island;
  const double share = static_cast<double>(island.ring(0, 4).size()) /
                       static_cast<double>(island.ring(0, 6.0000001).size());
  EXPECT_EQ(island.spread(island.ring(0, 4), 5, share), island.ring(0, 4));
  EXPECT_GT(island.spread(island.ring(0, 4), 5, share - 1e-6).size(), island.ring(0, 4).size());
}

// Nor to what is under the cloud, of the border, or most of what is left.
TEST(SpreadOnIslands, NotToAnythingElse) {
  Island island;
  const std::vector<TriangleId> outside = island.ring(8, 9);
  EXPECT_EQ(island.spread(outside, 5, 0), outside);
  EXPECT_EQ(island.spread(island.ring(6.5, 7), 5, 0), island.ring(6.5, 7));
  for (const TriangleId t : island.ring(0, 3)) island.under[t] = 1;
  EXPECT_EQ(island.spread(island.ring(0, 2), 5, 0), island.ring(0, 2));
  std::vector<TriangleId> none;
  EXPECT_EQ(island.spread(none, 5, 0), none);
}

TEST(SpreadOnIslands, RefusesFlagsOfAnotherModel) {
  const Island island;
  std::vector<TriangleId> none;
  EXPECT_THROW(spread_on_islands(island.model, TriangleSet(3, 0), 1, 0, none), InputError);
}

}  // namespace
}  // namespace cocoon
