#include "cocone/noise/outlier_rounds.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

struct Spaced {
  explicit Spaced(const std::vector<Point>& points, const NoiseOptions& options)
      : triangulation(delaunay(points).triangulation),
        stars(vertex_stars(triangulation)),
        spacing(sample_spacing(triangulation, stars, options.neighbors)),
        outliers(outlier_samples(triangulation, stars, spacing, options.outlier_ratio)) {}
  std::size_t count() const {
    std::size_t count = 0;
    for (const std::uint8_t flag : outliers) count += flag;
    return count;
  }
  Triangulation triangulation;
  VertexStars stars;
  IdVector<VertexId, double> spacing;
  VertexSet outliers;
};

struct Rest {
  std::vector<Point> points;
  std::size_t rounds;
  std::set<Point> spared;
};

// Arbitrary ones, or none.
bool is_spared(const Point& p, bool some) { return some && p.x > 0 && p.y > 0; }

// By a new triangulation in every round.
Rest plain_rounds(std::vector<Point> points, bool some_spared, const NoiseOptions& options) {
  std::set<Point> spared;
  for (std::size_t rounds = 1;; ++rounds) {
    const Spaced now(points, options);
    const IdVector<PointId, VertexId> vertex_of_point = now.triangulation.vertex_of_point();
    std::vector<Point> rest;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool outlier = now.outliers[vertex_of_point[PointId(i)]] != 0;
      const bool stays = is_spared(points[i], some_spared);
      if (outlier && stays) spared.insert(points[i]);
      if (!outlier || stays) rest.push_back(points[i]);
    }
    if (rest.size() == points.size()) return {points, rounds, spared};
    points = std::move(rest);
  }
}

// Ever farther out, ever farther apart.
std::vector<Point> thinning_cloud(std::size_t count, double power, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < count) {
    points.push_back(std::pow(1 - random.uniform(), -power) * random.on_unit_sphere());
  }
  return points;
}

OutlierRounds compare_with_plain_rounds(const std::vector<Point>& points, bool some_spared,
                                        const NoiseOptions& options) {
  Spaced first(points, options);
  const IdVector<PointId, VertexId> vertex_of_point = first.triangulation.vertex_of_point();
  VertexSet spared;
  if (some_spared) {
    spared = VertexSet(first.triangulation.num_vertices(), 0);
    for (const VertexId v : spared.ids()) {
      spared[v] = is_spared(first.triangulation.point(v), true) ? 1 : 0;
    }
  }
  OutlierRounds rounds = outlier_rounds(std::move(first.triangulation), std::move(first.spacing),
                                        first.outliers, spared, options, FlatSamples::refused);
  std::vector<Point> rest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (rounds.out[vertex_of_point[PointId(i)]] == 0) rest.push_back(points[i]);
  }
  const Rest plain = plain_rounds(points, some_spared, options);
  EXPECT_EQ(rest, plain.points);
  EXPECT_EQ(rounds.rounds, plain.rounds);
  EXPECT_EQ(rounds.count, points.size() - rest.size());
  EXPECT_EQ(rounds.spared, plain.spared.size());
  return rounds;
}

TEST(OutlierRounds, AreThoseOfNewTriangulations) {
  std::size_t most_rounds = 0;
  std::size_t spared = 0;
  for (const double ratio : {1.5, 2.0, 3.0}) {
    NoiseOptions options;
    options.outlier_ratio = ratio;
    for (const auto& points : {thinning_cloud(1500, 1, 3), thinning_cloud(1500, 2, 4),
                               shapes::joined(shapes::sphere(1500, 5),
                                              shapes::moved(shapes::random_cube(60, 6), {1, 0, 0})),
                               shapes::random_torus(2000, 0.4, 7)}) {
      for (const bool some_spared : {false, true}) {
        const OutlierRounds rounds = compare_with_plain_rounds(points, some_spared, options);
        most_rounds = std::max(most_rounds, rounds.rounds);
        spared += rounds.spared;
      }
    }
  }
  EXPECT_GE(most_rounds, 5U);
  EXPECT_GE(spared, 50U);
}

// A lattice on a plane, and one point far from it.
TEST(OutlierRounds, WhatIsLeftMustSpanSpace) {
  std::vector<Point> points;
  for (int i = 0; i < 25; ++i) points.push_back({double(i % 5), double(i / 5), 0});
  points.push_back({2, 2, 1e4});
  const NoiseOptions options;
  Spaced first(points, options);
  ASSERT_GE(first.count(), 1U);
  EXPECT_THROW(outlier_rounds(std::move(first.triangulation), std::move(first.spacing),
                              first.outliers, {}, options, FlatSamples::refused),
               InputError);
  Spaced again(points, options);
  const OutlierRounds rounds =
      outlier_rounds(std::move(again.triangulation), std::move(again.spacing), again.outliers, {},
                     options, FlatSamples::moved);
  EXPECT_TRUE(rounds.is_flat);
  EXPECT_EQ(rounds.count, again.count());
}

}  // namespace
}  // namespace cocoon
