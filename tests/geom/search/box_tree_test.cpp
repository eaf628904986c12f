#include "geom/search/box_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

// In all ways in which the counts of nodes are told from the number of items. Coarse coordinates,
// so that centers tie.
TEST(BoxTree, FindsWhatLooksAtAllBoxesFindOnEveryNumberOfThreads) {
  Random random(7);
  for (const std::size_t n : {1U, 4U, 5U, 9U, 1023U, 2048U, 2049U, 6001U, 20011U}) {
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < n; ++k) {
      const Point p = 16 * random.in_unit_cube();
      const Point low = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
      boxes.push_back({low, low + Vec3{1.5, 0, 1}});
    }
    const BoxTree tree(boxes);
    const BoxTree same(boxes, {.threads = 3});
    EXPECT_EQ(same.items(), tree.items());
    const Box asked{{3, 3, 3}, {7.5, 9, 4}};
    std::vector<std::uint8_t> met(n, 0);
    same.visit_overlapping(asked, [&](std::uint32_t slot) { ++met[same.items()[slot]]; });
    std::size_t all = 0;
    same.visit_near({0, 0, 0}, 1e9, [&](std::uint32_t slot) {
      all += slot < n ? 1U : 0U;
      return 1e9;
    });
    EXPECT_EQ(all, n);
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_LE(met[k], 1);
      EXPECT_GE(met[k], overlap(boxes[k], asked) ? 1 : 0) << k << " of " << n;
    }
    if (n > 1000) {
      EXPECT_LT(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(n / 2));
    }
  }
}

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

TEST(BoxTree, RaysFindWhatLooksAtAllBoxesFind) {
  Random random(9);
  std::vector<Box> boxes;
  for (int k = 0; k < 3000; ++k) {
    const Point low = random.in_unit_cube();
    boxes.push_back({low, low + 0.02 * random.in_unit_cube()});
  }
  const BoxTree tree(boxes);
  for (int k = 0; k < 50; ++k) {
    const Point p = random.in_unit_cube();
    const Vec3 way = random.in_unit_cube() - Vec3{0.5, 0.5, 0.5};
    const auto is_met = [&](std::uint32_t slot) {
      return ray_meets(p, way, boxes[tree.items()[slot]]);
    };
    std::size_t met = 0;
    EXPECT_FALSE(tree.any_on_ray(p, way, [&](std::uint32_t slot) {
      met += is_met(slot) ? 1U : 0U;
      return false;
    }));
    const auto all = std::count_if(boxes.begin(), boxes.end(),
                                   [&](const Box& box) { return ray_meets(p, way, box); });
    EXPECT_EQ(met, static_cast<std::size_t>(all));
    EXPECT_EQ(tree.any_on_ray(p, way, is_met), all > 0);
  }
}

}  // namespace
}  // namespace cocoon
