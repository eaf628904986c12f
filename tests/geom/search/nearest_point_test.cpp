#include "geom/search/nearest_point.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "geom/box.h"
#include "geom/errors.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(NearestPoint, AgreesWithLookingAtEveryPoint) {
  Random random(23);
  for (const bool on_grid : {false, true}) {  // a grid has many ties and equal points
    std::vector<Point> points;
    const auto make_point = [&]() -> Point {
      if (!on_grid) return random.in_unit_cube();
      const double x = static_cast<double>(random.below(6));
      const double y = static_cast<double>(random.below(6));
      return {x, y, static_cast<double>(random.below(6))};
    };
    for (int k = 0; k < 400; ++k) points.push_back(make_point());
    const NearestPointTree tree(points);
    for (int k = 0; k < 300; ++k) {
      const Point p = make_point() + (on_grid ? Vec3{0.5, 0.5, 0} : Vec3{});
      PointId expected(0);
      for (const PointId id : id_range<PointId>(points.size())) {
        const double d = squared_distance(p, points[id.index()]);
        const double best = squared_distance(p, points[expected.index()]);
        if (d < best || (d == best && points[id.index()] < points[expected.index()])) expected = id;
      }
      ASSERT_EQ(tree.nearest(p).point, expected);
      ASSERT_EQ(tree.nearest(p).squared_distance, squared_distance(p, points[expected.index()]));
    }
  }
}

// On a grid many points are as far as the reach, or equal.
TEST(NearestPoint, AnyNearAgreesWithLookingAtEveryPoint) {
  Random random(24);
  std::vector<Point> points;
  const auto some = [&] { return static_cast<double>(random.below(8)); };
  for (int k = 0; k < 200; ++k) points.push_back({some(), some(), some()});
  const NearestPointTree tree(points);
  EXPECT_EQ(tree.box(), box_of(points));
  const auto is_asked_for = [](PointId p) { return p.index() % 16 == 3; };
  std::size_t near = 0;
  std::size_t held = 0;
  for (int k = 0; k < 400; ++k) {
    const Point p = {some(), some(), some()};
    const double reach = 0.5 * static_cast<double>(random.below(6));
    bool any = false;
    bool any_held = false;
    for (const PointId id : id_range<PointId>(points.size())) {
      if (distance(p, points[id.index()]) > reach) continue;
      any = true;
      any_held = any_held || is_asked_for(id);
    }
    near += any ? 1U : 0U;
    held += any_held ? 1U : 0U;
    ASSERT_EQ(tree.any_near(p, reach), any);
    ASSERT_EQ(tree.any_near(p, reach, is_asked_for), any_held);
  }
  EXPECT_GT(near, held);
  EXPECT_GT(held, 40U);
  EXPECT_LT(near, 360U);
}

TEST(NearestPoint, ATreeOfEachCloud) {
  const std::vector<std::vector<Point>> clouds = {{{0, 0, 0}, {1, 0, 0}}, {{0, 5, 0}}};
  const std::vector<NearestPointTree> trees = nearest_point_trees(clouds, {.threads = 2});
  ASSERT_EQ(trees.size(), 2U);
  EXPECT_EQ(trees[0].nearest({2, 0, 0}).point, PointId(1U));
  EXPECT_EQ(trees[1].nearest({0, 0, 0}).squared_distance, 25);
}

TEST(NearestPoint, RefusesNoPointsAndNonFiniteOnes) {
  EXPECT_THROW(NearestPointTree({}), InputError);
  const std::vector<Point> bad = {{0, 0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THROW(NearestPointTree{bad}, InputError);
}

}  // namespace
}  // namespace cocoon
