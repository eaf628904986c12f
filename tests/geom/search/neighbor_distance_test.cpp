#include "geom/search/neighbor_distance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(NeighborDistance, OnAGrid) {
  std::vector<Point> points;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) points.push_back({2.0 * x, 2.0 * y, 0});
  }
  EXPECT_EQ(median_neighbor_distance(points, 1), 2);
  EXPECT_EQ(median_neighbor_distance(points, 4), 2);
  EXPECT_EQ(median_neighbor_distance(points, 8), std::sqrt(8.0));
}

TEST(NeighborDistance, AgreesWithBruteForceInAnyOrder) {
  Random random(3);
  std::vector<Point> points;
  points.reserve(301);
  for (int i = 0; i < 301; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  for (const std::size_t k : {1U, 3U, 8U}) {
    std::vector<double> distances;
    distances.reserve(points.size());
    for (const Point& p : points) {
      std::vector<double> all;
      all.reserve(points.size());
      for (const Point& q : points) all.push_back(distance(p, q));
      std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k), all.end());
      distances.push_back(all[k]);
    }
    std::nth_element(distances.begin(), distances.begin() + 150, distances.end());
    EXPECT_NEAR(median_neighbor_distance(points, k), distances[150], 1e-15);
    std::reverse(points.begin(), points.end());
    EXPECT_NEAR(median_neighbor_distance(points, k), distances[150], 1e-15);
  }
}

// Squares of such distances are no doubles.
TEST(NeighborDistance, OfCoordinatesOfAnySize) {
  for (const double size : {1e-300, 1e-170, 1e170, 1e300}) {
    const std::vector<Point> points = {{0, 0, 0}, {size, 0, 0}, {3 * size, 0, 0}, {5 * size, 0, 0}};
    EXPECT_NEAR(median_neighbor_distance(points, 1) / size, 2, 1e-15) << size;
  }
}

TEST(NeighborDistance, NothingWithoutNeighbors) {
  const std::vector<Point> points = {{1, 0, 0}, {1, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(median_neighbor_distance(points, 1), 3);
  EXPECT_EQ(median_neighbor_distance(points, 2), 0);
  EXPECT_EQ(median_neighbor_distance({}, 1), 0);
}

TEST(NeighborDistance, NeighborsAreCountedFromOne) {
  const std::vector<Point> points = {{1, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  EXPECT_THROW(median_neighbor_distance(points, 0), InputError);
}

}  // namespace
}  // namespace cocoon
