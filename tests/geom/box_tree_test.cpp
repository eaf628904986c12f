#include "geom/box_tree.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random.h"

namespace cocoon {
namespace {

// On a lattice, so that many lie at just the distance asked for.
TEST(CountNear, AsOneByOne) {
  Random random(4);
  std::vector<Point> points;
  points.reserve(400);
  for (int i = 0; i < 400; ++i) {
    points.push_back({static_cast<double>(random.below(8)), static_cast<double>(random.below(8)),
                      static_cast<double>(random.below(8))});
  }
  const BoxTree tree = tree_of_points(points);
  for (const Point& p : points) {
    for (const double reach : {0.0, 1.0, 4.0, 5.5}) {
      const auto expected =
          static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const Point& q) {
            return squared_distance(p, q) <= reach;
          }));
      EXPECT_EQ(count_near(tree, points, p, reach, points.size()), expected);
      EXPECT_EQ(count_near(tree, points, p, reach, 3), std::min<std::size_t>(expected, 4));
      EXPECT_EQ(count_near(tree, points, p, reach, 0), 1U);
    }
  }
  EXPECT_EQ(count_near(tree_of_points({}), {}, {0, 0, 0}, 1, 5), 0U);
}

}  // namespace
}  // namespace cocoon
