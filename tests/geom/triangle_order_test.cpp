#include "geom/triangle_order.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

Triangle triangle(int a, int b, int c) { return {VertexId(a), VertexId(b), VertexId(c)}; }

TEST(TriangleOrder, TurnsTheSmallestVertexToTheFront) {
  EXPECT_EQ(smallest_first(triangle(1, 2, 3)), triangle(1, 2, 3));
  EXPECT_EQ(smallest_first(triangle(3, 1, 2)), triangle(1, 2, 3));
  EXPECT_EQ(smallest_first(triangle(2, 3, 1)), triangle(1, 2, 3));
  EXPECT_EQ(smallest_first(triangle(3, 2, 1)), triangle(1, 3, 2));
}

TEST(TriangleOrder, OfEqualVerticesTheEarlierOneComesFirst) {
  EXPECT_EQ(smallest_first(triangle(1, 1, 2)), triangle(1, 1, 2));
  EXPECT_EQ(smallest_first(triangle(1, 2, 1)), triangle(1, 2, 1));
  EXPECT_EQ(smallest_first(triangle(2, 1, 1)), triangle(1, 1, 2));
}

// An id that is not set is above all others: a list compared from one on would look unsorted.
TEST(TriangleOrder, NoTriangleIsBelowTheLowest) {
  EXPECT_FALSE(triangle(0, 0, 0) < lowest_triangle);
  EXPECT_TRUE(lowest_triangle < triangle(0, 1, 2));
  EXPECT_TRUE(lowest_triangle < Triangle{});
}

}  // namespace
}  // namespace cocoon
