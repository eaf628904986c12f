#include "geom/spatial_order.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

// A third spread over the cube, a third in a tiny corner of it, a third equal to others.
std::vector<Point> mixed_points(std::size_t count) {
  Random random(7);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double scale = i % 3 == 0 ? 1.0 : 0x1p-20;
    const Point p = scale * Point{random.uniform(), random.uniform(), random.uniform()};
    points.push_back(i % 3 == 2 && i > 10 ? points[i / 2] : p);
  }
  return points;
}

std::vector<Point> in_order(const std::vector<Point>& points, const Execution& execution) {
  const std::vector<PointId> order = hilbert_order(points, execution);
  std::vector<bool> is_seen(points.size());
  std::vector<Point> sorted;
  for (const PointId p : order) {
    EXPECT_FALSE(is_seen[p.index()]);
    is_seen[p.index()] = true;
    sorted.push_back(points[p.index()]);
  }
  EXPECT_EQ(sorted.size(), points.size());
  return sorted;
}

TEST(HilbertOrder, HasEachPointOnceWhateverTheOrderOfInput) {
  for (const std::size_t count : {1U, 2U, 63U, 64U, 65U, 1000U, 20000U, 70000U}) {
    SCOPED_TRACE(count);
    std::vector<Point> points = mixed_points(count);
    const std::vector<Point> expected = in_order(points, {});
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(in_order(points, {.threads = 3}), expected);
  }
}

TEST(HilbertOrder, NeighborsAreNear) {
  constexpr std::size_t count = 64000;
  Random random(8);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({random.uniform(), random.uniform(), random.uniform()});
  }
  const std::vector<Point> sorted = in_order(points, {});
  double length = 0;
  for (std::size_t i = 1; i < count; ++i) length += norm(sorted[i] - sorted[i - 1]);
  const double spacing = 1 / std::cbrt(static_cast<double>(count));
  EXPECT_LT(length / count, 1.5 * spacing);
}

}  // namespace
}  // namespace cocoon
