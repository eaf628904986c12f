#include "geom/box.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

TEST(Box, EmptyOne) {
  const Box empty;
  EXPECT_TRUE(empty.is_empty());
  EXPECT_EQ(empty.size(), Vec3{});
  EXPECT_EQ(empty.center(), Point{});
  EXPECT_FALSE(contains(empty, {0, 0, 0}));
  EXPECT_EQ(box_of({}), empty);
}

TEST(Box, OfPoints) {
  const Box box = box_of(std::vector<Point>{{1, 5, 3}, {2, 4, 3}, {1, 6, 0}});
  EXPECT_EQ(box, (Box{{1, 4, 0}, {2, 6, 3}}));
  EXPECT_EQ(box.size(), (Vec3{1, 2, 3}));
  EXPECT_EQ(box.center(), (Point{1.5, 5, 1.5}));
}

TEST(Box, IncludingAnEmptyOneChangesNothing) {
  Box box = box_of(std::vector<Point>{{1, 2, 3}});
  const Box before = box;
  box.include(Box());
  EXPECT_EQ(box, before);
  Box empty;
  empty.include(Box());
  EXPECT_TRUE(empty.is_empty());
  empty.include(before);
  EXPECT_EQ(empty, before);
}

TEST(Box, EnlargedOnAllSides) {
  Box box{{0, 0, 0}, {1, 2, 3}};
  box.enlarge(1);
  EXPECT_EQ(box, (Box{{-1, -1, -1}, {2, 3, 4}}));
}

TEST(Box, IsClosed) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(contains(box, {1, 0, 0.5}));
  EXPECT_FALSE(contains(box, {1, 0, 1.5}));
  EXPECT_TRUE(overlap(box, {{1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(overlap(box, {{0, 1.5, 0}, {1, 2, 1}}));
  EXPECT_FALSE(overlap(box, Box()));
}

TEST(Box, IsNoFartherThanThePointsInIt) {
  Random random(5);
  const auto in_cube = [&] {
    return Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Point> points = {in_cube(), in_cube(), in_cube()};
    const Box box = box_of(points);
    const Point p = 2 * in_cube();
    for (const Point& q : points) {
      EXPECT_TRUE(contains(box, q));
      EXPECT_LE(squared_distance(p, box), squared_distance(p, q)) << p << q;
    }
    EXPECT_EQ(squared_distance(p, box) == 0, contains(box, p)) << p;
  }
  EXPECT_EQ(squared_distance(Point{3, 0.5, -1}, Box{{0, 0, 0}, {1, 1, 1}}), 5);
}

TEST(Box, RaysMeetWhatLiesBeforeThem) {
  const Box box{{1, -1, -1}, {2, 1, 1}};
  EXPECT_TRUE(ray_meets({0, 0, 0}, {1, 0, 0}, box));
  EXPECT_TRUE(ray_meets({0, 0, 0}, {1, 0.9, -0.9}, box));
  EXPECT_TRUE(ray_meets({1.5, 0, 0}, {0, 0, 1}, box));  // from inside
  EXPECT_FALSE(ray_meets({0, 0, 0}, {-1, 0, 0}, box));  // it lies behind
  EXPECT_FALSE(ray_meets({0, 0, 0}, {1, 1.5, 0}, box));
  EXPECT_FALSE(ray_meets({0, 2, 0}, {1, 0, 0}, box));
  const Box flat{{1, -1, -1}, {1, 1, 1}};
  EXPECT_TRUE(ray_meets({0, 0, 0}, {1, 0.5, 0.5}, flat));
  EXPECT_TRUE(ray_meets({1, -3, 0}, {0, 1, 0}, flat));
}

// Rays towards random points of random boxes, and away from them where the box is not around.
TEST(Box, RaysMeetTheBoxesOfTheirPoints) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const Box box = box_of(std::vector<Point>{random.in_unit_cube(), random.in_unit_cube()});
    const Vec3 size = box.size();
    const Vec3 share = random.in_unit_cube();
    const Point inside = box.low + Vec3{share.x * size.x, share.y * size.y, share.z * size.z};
    const Point p = 3 * random.in_unit_cube() - Vec3{1, 1, 1};
    EXPECT_TRUE(ray_meets(p, inside - p, box));
    EXPECT_EQ(ray_meets(p, p - inside, box), contains(box, p));
  }
}

}  // namespace
}  // namespace cocoon
