#include "geom/closest_on_segment.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

TEST(ClosestOnSegment, IsAnEndOrTheFootOfThePerpendicular) {
  const Point a = {1, 1, 0};
  const Point b = {5, 1, 0};
  EXPECT_EQ(closest_on_segment({2, 7, 3}, a, b), (Point{2, 1, 0}));
  EXPECT_EQ(closest_on_segment({0, 7, 3}, a, b), a);
  EXPECT_EQ(closest_on_segment({5.5, 1, 0}, a, b), b);
  EXPECT_EQ(closest_on_segment({4, 4, 4}, a, a), a);
}

}  // namespace
}  // namespace cocoon
