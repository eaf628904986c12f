#include "cocone/checks/surface_doubts.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "geom/box.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

TEST(SurfaceDoubts, NoneOnCleanSurfaces) {
  const std::vector<Point> points = shapes::torus(100, 50, 0.4, 0.5, 1);
  const SurfaceDoubts doubts = surface_doubts(reconstruct_tight(points), points);
  EXPECT_GT(doubts.spacing, 0.03);
  EXPECT_LT(doubts.spacing, 0.1);
  EXPECT_LT(doubts.roughness, 0.05);
  EXPECT_EQ(doubts.boundary_samples, 0U);
  EXPECT_EQ(doubts.fragments + doubts.unused_points + doubts.bad_edges, 0U);
  EXPECT_TRUE(doubts.sparse.empty() && doubts.dust.empty() && doubts.unused.empty());
}

TEST(SurfaceDoubts, TellWhatTheStagesCounted) {
  std::vector<Point> points = shapes::torus(100, 50, 0.4, 0.5, 1);
  ReconstructResult result = reconstruct_tight(points);
  SurfaceDoubts doubts = surface_doubts(result, points);
  EXPECT_EQ(doubts.samples, points.size());
  EXPECT_EQ(doubts.unsurrounded_samples + doubts.conflicts, 0U);
  points = shapes::noisy_sphere(2000, 0.03, 2);  // more than half of the spacing
  result = reconstruct_tight(points);
  doubts = surface_doubts(result, points);
  EXPECT_GT(doubts.unsurrounded_samples, points.size() / 5);
  EXPECT_EQ(doubts.unsurrounded_samples, points.size() - result.counters.umbrellas);
  EXPECT_EQ(doubts.conflicts, result.counters.marking_conflicts);
}

// Which of many contacts have places is not told by the order of points.
TEST(SurfaceDoubts, PlaceContactsAsTheSurfaceHasThem) {
  std::vector<Point> points = shapes::noisy_sphere(1500, 0.05, 2);
  ReconstructOptions options;
  options.clean_up.enabled = false;
  const SurfaceDoubts doubts = surface_doubts(reconstruct_tight(points, options), points);
  ASSERT_GT(doubts.bad_edges + doubts.pinched_vertices, 16U);
  std::reverse(points.begin(), points.end());
  const SurfaceDoubts reversed = surface_doubts(reconstruct_tight(points, options), points);
  EXPECT_EQ(reversed.contacts, doubts.contacts);
  EXPECT_LT(doubts.contacts[0].at, doubts.contacts[1].at);  // each place once
}

// Lengths, their squares and places, where squares leave the range of double.
TEST(SurfaceDoubts, AreTheSameAtAnyScale) {
  std::vector<Point> points = shapes::noisy_sphere(600, 0.03, 2);
  points.push_back({0.1, 0.2, 0.05});
  points.push_back({3, 0, 0});
  const SurfaceDoubts doubts = surface_doubts(reconstruct_tight(points), points);
  ASSERT_FALSE(doubts.unused.empty() || doubts.sparse.empty());
  for (const double scale : {0x1p+600, 0x1p-600}) {
    std::vector<Point> scaled = points;
    for (Point& p : scaled) p = scale * p;
    const SurfaceDoubts of_scaled = surface_doubts(reconstruct_tight(scaled), scaled);
    EXPECT_EQ(of_scaled.spacing, scale * doubts.spacing);
    EXPECT_EQ(of_scaled.roughness, doubts.roughness);
    EXPECT_EQ(of_scaled.gap_samples, doubts.gap_samples);
    const auto expect_scaled = [&](const std::vector<DoubtfulSpot>& actual,
                                   const std::vector<DoubtfulSpot>& expected) {
      ASSERT_EQ(actual.size(), expected.size());
      for (std::size_t k = 0; k < actual.size(); ++k) {
        EXPECT_EQ(actual[k].at, scale * expected[k].at);
        EXPECT_EQ(actual[k].size, scale * expected[k].size);
        EXPECT_EQ(actual[k].count, expected[k].count);
      }
    };
    expect_scaled(of_scaled.sparse, doubts.sparse);
    expect_scaled(of_scaled.unused, doubts.unused);
    expect_scaled(of_scaled.dust, doubts.dust);
  }
}

// Two sheets closer than their samples, beside a ball that leaves no doubt.
TEST(SurfaceDoubts, PlaceContradictionsAndHandles) {
  Random random(7);
  std::vector<Point> points = shapes::sphere(800, 20, 0.5, {5, 0, 0});
  for (int i = 0; i < 4000; ++i) {
    const double z = i % 2 == 0 ? 0 : 0.02;
    points.push_back({random.uniform(-1, 1), random.uniform(-1, 1), z});
  }
  const ReconstructResult result = reconstruct_tight(points, {.second_look = {.enabled = false}});
  const SurfaceDoubts doubts = surface_doubts(result, points);
  ASSERT_GT(doubts.conflicts, 0U);
  ASSERT_GT(doubts.contradicted.size(), 1U);
  EXPECT_GE(doubts.contradicted[0].count, doubts.contradicted[1].count);
  ASSERT_GT(doubts.certificate.genus.value_or(0), 3U);
  ASSERT_EQ(doubts.handles.size(), 3U);
  EXPECT_LE(doubts.handles[0].size, doubts.handles[1].size);
  for (const auto& spots : {doubts.contradicted, doubts.handles}) {
    for (const DoubtfulSpot& spot : spots) {
      EXPECT_LT(spot.at.x, 2);
      EXPECT_GE(spot.count, 1U);
      EXPECT_GT(spot.size, 0);
    }
  }
  EXPECT_TRUE(surface_doubts(result, points, {.place_handles = false}).handles.empty());
}

// At its rim no sample has an umbrella, and nothing was guessed there.
TEST(SurfaceDoubts, AnOpenSurfaceIsNoGuess) {
  std::vector<Point> strip;
  for (int i = 0; i < 160; ++i) {
    const double x = 0.1 * (i / 4) + 0.02 * (i % 3);
    strip.push_back({x, 0.1 * (i % 4) + 0.01 * (i % 5), 0.05 * x * x});
  }
  const ReconstructResult result = reconstruct_cocone(strip, open_cloud_defaults());
  ASSERT_FALSE(result.mesh.triangles.empty());
  EXPECT_LT(result.counters.umbrellas, strip.size());
  EXPECT_EQ(surface_doubts(result, strip).unsurrounded_samples, 0U);
}

TEST(SurfaceDoubts, RoughnessMeasuresNoise) {
  Random random(2);
  std::vector<Point> points;  // even, with noise of a tenth of the spacing along the normal
  const std::size_t n = 4000;
  const double spacing = std::sqrt(4 * std::numbers::pi / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double r = std::sqrt(1 - z * z);
    const double turn = static_cast<double>(i) * 2.399963229728653;
    points.push_back((1 + 0.1 * spacing * random.gaussian()) *
                     Point{r * std::cos(turn), r * std::sin(turn), z});
  }
  const SurfaceDoubts doubts = surface_doubts(reconstruct_tight(points), points);
  EXPECT_NEAR(doubts.roughness, 0.07, 0.02);
}

TEST(SurfaceDoubts, NamesTheWorstSpots) {
  // a sphere without its top; a second, tiny one; a point in the middle
  std::vector<Point> points = shapes::cut_sphere(6000, 0.8, 3);
  points = shapes::joined(points, shapes::sphere(20, 4, 0.05, {3, 0, 0}));
  points.push_back({0, 0, -0.5});
  const ReconstructResult result = reconstruct_tight(points);
  const SurfaceDoubts doubts = surface_doubts(result, points);
  ASSERT_FALSE(doubts.sparse.empty());
  EXPECT_NEAR(doubts.sparse[0].at.z, 0.8, 0.05);
  EXPECT_GT(doubts.sparse[0].size, 4 * doubts.spacing);
  ASSERT_FALSE(doubts.unused.empty());
  EXPECT_EQ(doubts.unused_points, result.unused_points);
  ASSERT_EQ(doubts.fragments, 1U);
  EXPECT_NEAR(doubts.dust[0].at.x, 3, 0.1);
  for (std::size_t k = 1; k < doubts.unused.size(); ++k) {
    EXPECT_GE(doubts.unused[k - 1].size, doubts.unused[k].size);
  }
}

// The definitions, word by word.
class PlainDoubts {
 public:
  PlainDoubts(const ReconstructResult& result, const std::vector<Point>& points,
              const SurfaceDoubtOptions& options)
      : result_(result), mesh_(result.mesh), options_(options) {
    for (const TriangleId id : mesh_.triangles.ids()) {
      const Triangle& t = mesh_.triangles[id];
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = t[k];
        const VertexId b = t[(k + 1) % 3];
        triangles_at_[{std::min(a, b), std::max(a, b)}].push_back(id);
        neighbors_[a].insert(b);
        neighbors_[b].insert(a);
        normal_[a] = normal_[a] + cross(mesh_.points[b] - mesh_.points[a],
                                        mesh_.points[t[(k + 2) % 3]] - mesh_.points[a]);
      }
    }
    measure();
    group_sparse();
    list_dust();
    std::set<Point> unused(points.begin(), points.end());
    for (const Point& q : mesh_.points) unused.erase(q);
    for (const Point& p : unused) {
      double least = std::numeric_limits<double>::infinity();
      for (const Point& q : mesh_.points) least = std::min(least, distance(p, q));
      doubts_.unused.push_back({p, 1, least});
    }
    keep_worst(doubts_.unused);
  }

  const SurfaceDoubts& doubts() const { return doubts_; }

 private:
  using Edge = std::pair<VertexId, VertexId>;

  static double middle(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }

  void measure() {
    std::vector<double> edges;
    std::vector<double> deviations;
    for (const auto& [edge, triangles] : triangles_at_) edges.push_back(length(edge));
    doubts_.spacing = middle(edges);
    for (const auto& [v, around] : neighbors_) {
      std::vector<double> lengths;
      Vec3 arms;
      double sum = 0;
      for (const VertexId w : around) {
        arms = arms + (mesh_.points[w] - mesh_.points[v]);
        lengths.push_back(length({v, w}));
        sum += lengths.back();
      }
      deviations.push_back(std::abs(dot(arms, unit(normal_[v]))) / sum);
      longest_[v] = *std::max_element(lengths.begin(), lengths.end());
      const bool gap = longest_[v] > options_.gap_ratio * middle(lengths);
      const bool boundary = result_.boundary_sample[v] != 0;
      doubts_.boundary_samples += boundary ? 1U : 0U;
      doubts_.gap_samples += gap && !boundary ? 1U : 0U;
      if (gap || boundary) sparse_.insert(v);
    }
    doubts_.roughness = middle(deviations);
  }

  double length(const Edge& edge) const {
    return distance(mesh_.points[edge.first], mesh_.points[edge.second]);
  }

  void group_sparse() {
    std::set<VertexId> left = sparse_;
    while (!left.empty()) {
      std::vector<VertexId> group{*left.begin()};
      left.erase(left.begin());
      for (std::size_t k = 0; k < group.size(); ++k) {
        for (const VertexId w : neighbors_[group[k]]) {
          if (left.erase(w) != 0) group.push_back(w);
        }
      }
      const VertexId worst =
          *std::min_element(group.begin(), group.end(), [&](VertexId a, VertexId b) {
            return std::tuple(-longest_[a], mesh_.points[a]) <
                   std::tuple(-longest_[b], mesh_.points[b]);
          });
      doubts_.sparse.push_back({mesh_.points[worst], group.size(), longest_[worst]});
    }
    keep_worst(doubts_.sparse);
  }

  void list_dust() {
    std::vector<std::vector<TriangleId>> components;
    std::set<TriangleId> seen;
    for (const TriangleId first : mesh_.triangles.ids()) {
      if (!seen.insert(first).second) continue;
      components.push_back({first});
      for (std::size_t k = 0; k < components.back().size(); ++k) {
        const Triangle& t = mesh_.triangles[components.back()[k]];
        for (std::size_t i = 0; i < 3; ++i) {
          const auto [a, b] = std::minmax(t[i], t[(i + 1) % 3]);
          for (const TriangleId other : triangles_at_[{a, b}]) {
            if (seen.insert(other).second) components.back().push_back(other);
          }
        }
      }
    }
    std::size_t largest = 0;
    for (const auto& component : components) largest = std::max(largest, component.size());
    for (const auto& component : components) {
      if (!(static_cast<double>(component.size()) <
            options_.fragment_share * static_cast<double>(largest))) {
        continue;
      }
      Box box;
      for (const TriangleId t : component) {
        for (const VertexId v : mesh_.triangles[t]) box.include(mesh_.points[v]);
      }
      ++doubts_.fragments;
      doubts_.dust.push_back({box.center(), component.size(), norm(box.size())});
    }
    std::sort(doubts_.dust.begin(), doubts_.dust.end(),
              [](const DoubtfulSpot& a, const DoubtfulSpot& b) {
                return std::tuple(b.count, a.at) < std::tuple(a.count, b.at);
              });
    doubts_.dust.resize(std::min(doubts_.dust.size(), options_.max_spots));
  }

  void keep_worst(std::vector<DoubtfulSpot>& spots) const {
    std::sort(spots.begin(), spots.end(), [](const DoubtfulSpot& a, const DoubtfulSpot& b) {
      return std::tuple(-a.size, a.at) < std::tuple(-b.size, b.at);
    });
    spots.resize(std::min(spots.size(), options_.max_spots));
  }

  const ReconstructResult& result_;
  const TriangleMesh& mesh_;
  const SurfaceDoubtOptions& options_;
  std::map<Edge, std::vector<TriangleId>> triangles_at_;
  std::map<VertexId, std::set<VertexId>> neighbors_;
  std::map<VertexId, Vec3> normal_;
  std::map<VertexId, double> longest_;
  std::set<VertexId> sparse_;
  SurfaceDoubts doubts_;
};

// A surface with some triangles turned, some missing, some more anywhere, and single ones apart;
// behind its vertices copies of some, and points that it does not have, some of them twice.
ReconstructResult torn_surface(std::uint64_t seed, std::vector<Point>& points) {
  Random random(seed);
  ReconstructResult result = reconstruct_tight(shapes::noisy_sphere(400, 0.02, seed));
  std::erase_if(result.mesh.triangles.raw(), [&](const Triangle&) { return random.below(9) == 0; });
  for (Triangle& t : result.mesh.triangles) {
    if (random.below(9) == 0) std::swap(t[0], t[1]);
  }
  const auto vertex = [&] {
    return VertexId(std::size_t{random.below(result.mesh.points.size())});
  };
  for (int i = 0; i < 20; ++i) {
    const Triangle t{vertex(), vertex(), vertex()};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) result.mesh.triangles.push_back(t);
  }
  for (int i = 0; i < 9; ++i) {  // of equal size: ties
    const std::size_t first = result.mesh.points.size();
    for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{0.25, 0, 0}, Vec3{0, 0.25, 0}}) {
      result.mesh.points.push_back(Point{2.0 + i, 0, 0} + corner);
    }
    result.mesh.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  }
  points.assign(result.mesh.points.begin(), result.mesh.points.end());
  result.point_of_vertex = {};
  result.boundary_sample = {};
  for (const VertexId v : result.mesh.points.ids()) {
    result.point_of_vertex.push_back(PointId(v.value));
    result.boundary_sample.push_back(random.below(20) == 0 ? 1 : 0);
  }
  return result;
}

TEST(SurfaceDoubts, AreTheirDefinitionsOnTornSurfaces) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (const std::size_t unused : {5U, 200U}) {
      std::vector<Point> points;
      ReconstructResult result = torn_surface(seed, points);
      const std::vector<Point> others = shapes::random_cube(unused, seed);
      for (const auto& more :
           {others, others, std::vector<Point>(points.begin(), points.begin() + 9)}) {
        points.insert(points.end(), more.begin(), more.end());
      }
      result.unused_points = unused;
      result.duplicates = unused + 9;
      for (const SurfaceDoubtOptions& options :
           {SurfaceDoubtOptions{}, {.max_spots = 100, .gap_ratio = 2, .fragment_share = 1}}) {
        const SurfaceDoubts actual = surface_doubts(result, points, options);
        const SurfaceDoubts expected = PlainDoubts(result, points, options).doubts();
        EXPECT_EQ(actual.spacing, expected.spacing);
        EXPECT_NEAR(actual.roughness, expected.roughness, 1e-12);
        EXPECT_EQ(actual.boundary_samples, expected.boundary_samples);
        EXPECT_EQ(actual.gap_samples, expected.gap_samples);
        EXPECT_EQ(actual.sparse, expected.sparse);
        EXPECT_EQ(actual.fragments, expected.fragments);
        EXPECT_EQ(actual.dust, expected.dust);
        EXPECT_EQ(actual.unused, expected.unused);
      }
    }
  }
}

TEST(SurfaceDoubts, EmptyResultsHaveNone) {
  const std::vector<Point> points = shapes::random_cube(30, 5);
  EXPECT_EQ(surface_doubts(ReconstructResult(), points).spacing, 0);
}

TEST(SurfaceDoubts, TheLargestSpotsAreKeptTiesByPlace) {
  const std::vector<DoubtfulSpot> spots = {
      {{2, 0, 0}, 1, 5}, {{1, 0, 0}, 1, 5}, {{0, 0, 0}, 1, 4}, {{3, 0, 0}, 1, 7}};
  std::vector<DoubtfulSpot> kept = spots;
  keep_largest(kept, 2);
  EXPECT_EQ(kept, (std::vector<DoubtfulSpot>{spots[3], spots[1]}));
  kept = spots;
  keep_largest(kept, 9);
  EXPECT_EQ(kept, (std::vector<DoubtfulSpot>{spots[3], spots[1], spots[0], spots[2]}));
}

}  // namespace
}  // namespace cocoon
