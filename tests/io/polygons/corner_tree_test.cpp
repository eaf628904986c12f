#include "io/polygons/corner_tree.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

std::vector<std::size_t> found_near(const CornerTree& tree, const std::array<Planar, 3>& triangle) {
  std::vector<std::size_t> found;
  tree.visit_near(triangle, [&](std::size_t point) {
    found.push_back(point);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool is_in(const std::array<Planar, 3>& triangle, const Planar& p) {
  return turn(triangle[0], triangle[1], p) != Sign::negative &&
         turn(triangle[1], triangle[2], p) != Sign::negative &&
         turn(triangle[2], triangle[0], p) != Sign::negative;
}

TEST(CornerTree, FindsAllThatAreLeftInATriangle) {
  for (const double size : {1.0, 1e-300, 1e300}) {
    Random random(5);
    std::vector<Planar> points;
    // Many lie on the sides of the triangles, or at one place.
    const auto some = [&] { return size * (static_cast<double>(random.below(12)) - 5.0); };
    for (std::size_t i = 0; i < 700; ++i) {
      const double x = some();
      points.push_back({x, some()});
    }
    CornerTree tree(points);
    std::vector<char> is_away(points.size(), 0);
    std::size_t in_all = 0;
    for (std::size_t step = 0; step < points.size(); ++step) {
      std::array<Planar, 3> triangle;
      for (Planar& p : triangle) p = points[random.below(points.size())];
      if (turn(triangle[0], triangle[1], triangle[2]) == Sign::positive) {
        const std::vector<std::size_t> found = found_near(tree, triangle);
        for (std::size_t i = 0; i < points.size(); ++i) {
          const bool is_found = std::binary_search(found.begin(), found.end(), i);
          const bool is_to_be_found = is_away[i] == 0 && is_in(triangle, points[i]);
          ASSERT_FALSE(is_found && is_away[i] != 0);
          ASSERT_TRUE(is_found || !is_to_be_found);
          in_all += is_found ? 1 : 0;
        }
      }
      const std::size_t away = (step * 37) % points.size();
      is_away[away] = 1;
      tree.take_away(away);
    }
    EXPECT_GT(in_all, 1000U);
    EXPECT_TRUE(found_near(tree, {Planar{-9, -9}, Planar{99, -9}, Planar{-9, 99}}).empty());
  }
}

TEST(CornerTree, LooksAtFewThatAreOutside) {
  std::vector<Planar> points;
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k < 100; ++k)
      points.push_back({static_cast<double>(i), static_cast<double>(k)});
  }
  const CornerTree tree(points);
  // A thin one across all.
  EXPECT_LT(found_near(tree, {Planar{0, 0}, Planar{99, 98}, Planar{99, 99}}).size(), 1500U);
}

TEST(CornerTree, StopsWhenItIsTold) {
  const std::vector<Planar> points(50, Planar{1, 1});
  const CornerTree tree(points);
  int calls = 0;
  tree.visit_near({Planar{0, 0}, Planar{3, 0}, Planar{0, 3}},
                  [&](std::size_t) { return ++calls < 7; });
  EXPECT_EQ(calls, 7);
  const CornerTree empty(std::span<const Planar>{});
  EXPECT_TRUE(found_near(empty, {Planar{0, 0}, Planar{3, 0}, Planar{0, 3}}).empty());
}

}  // namespace
}  // namespace cocoon
