#include "geom/mesh/triangle_order.h"

#include <gtest/gtest.h>
#include <vector>

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

TEST(TriangleOrder, PrecedesAsTheOperatorTells) {
  std::vector<Triangle> triangles{Triangle{}, lowest_triangle};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 3; ++c) triangles.push_back(triangle(a, b, c));
    }
  }
  for (const Triangle& a : triangles) {
    for (const Triangle& b : triangles) EXPECT_EQ(precedes(a, b), a < b);
  }
}

}  // namespace
}  // namespace cocoon
