#include "update/cloud/rim_edges.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// The rim of the square from 2 to 5 in the plane: edges of length 1.
struct SquareRim {
  CloudRim rim;
  SquareRim() {
    TriangleMesh surface = testing::grid_plane(3);
    for (Point& p : surface.points) p = p + Vec3{2, 2, 0};
    rim = cloud_rim(surface);
  }
  // The one whose middle is nearest.
  static std::size_t edge_at(const std::vector<RimEdge>& edges, const Point& p) {
    const auto nearest =
        std::min_element(edges.begin(), edges.end(), [&](const RimEdge& a, const RimEdge& b) {
          return distance(a.middle, p) < distance(b.middle, p);
        });
    return static_cast<std::size_t>(nearest - edges.begin());
  }
};

TEST(RimEdges, EndsOfTheCloudPointAwayFromIt) {
  SquareRim square;
  ASSERT_EQ(square.rim.loops.size(), 1U);
  const std::vector<RimEdge> edges = ends_of_cloud(square.rim);
  ASSERT_EQ(edges.size(), 12U);
  const Point center = {3.5, 3.5, 0};
  for (const RimEdge& edge : edges) {
    EXPECT_EQ(edge.middle, square.rim.loops[0].middle(edge.index));
    EXPECT_NEAR(norm(edge.outward), 1, 1e-12);
    EXPECT_GT(dot(edge.outward, edge.middle - center), 0);
  }
  // Where the cloud goes on it does not end.
  square.rim.loops[0].inner.assign(12, 0);
  square.rim.loops[0].inner[4] = 1;
  const std::vector<RimEdge> fewer = ends_of_cloud(square.rim);
  EXPECT_EQ(fewer.size(), 11U);
  EXPECT_TRUE(
      std::none_of(fewer.begin(), fewer.end(), [](const RimEdge& e) { return e.index == 4; }));
}

TEST(RimEdges, SamplesBeyondAreWithinReachAndOutside) {
  const SquareRim square;
  const std::vector<RimEdge> edges = ends_of_cloud(square.rim);
  const std::vector<Point> samples = {{3.5, 1.5, 0}, {3.5, 2.2, 0}, {3.5, 0.9, 0}, {9, 9, 9}};
  const std::size_t low = SquareRim::edge_at(edges, {3.5, 2, 0});
  const auto beyond_it = [&](double reach, double outward) {
    std::vector<std::uint32_t> found;
    std::size_t last = 0;
    for (const SampleBeyond& pair : samples_beyond(edges, samples, reach, outward)) {
      EXPECT_LE(last, pair.edge);
      last = pair.edge;
      if (pair.edge == low) found.push_back(pair.sample);
    }
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(beyond_it(1, 0), std::vector<std::uint32_t>{0});
  EXPECT_EQ(beyond_it(1, -0.3), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(beyond_it(1.2, 0), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_TRUE(beyond_it(1.2, 1.15).empty());
  EXPECT_TRUE(samples_beyond(edges, {}, 1, 0).empty());
}

TEST(RimEdges, SamplesNearAreAllWithinReachAndNoneFarAway) {
  const SquareRim square;
  const std::vector<RimEdge> edges = ends_of_cloud(square.rim);
  const std::vector<std::vector<Point>> clouds = {{{3.5, 1.5, 0}, {90, 90, 90}}, {{1.6, 3.5, 0}}};
  const std::vector<Point> near = samples_near(clouds, edges, 1);
  for (const Point& p : {clouds[0][0], clouds[1][0]}) {
    EXPECT_NE(std::find(near.begin(), near.end(), p), near.end());
  }
  EXPECT_EQ(std::find(near.begin(), near.end(), clouds[0][1]), near.end());
  EXPECT_TRUE(samples_near(clouds, {}, 1).empty());
}

// Over a plane: a sample higher than the edge that it lies beyond is a step.
TEST(RimEdges, StepsAreDifferencesOfHeight) {
  const TriangleMesh plane = testing::grid_plane(8);
  const ModelIndex model(plane);
  SquareRim square;
  const auto steps_of = [&](double edge_height, double sample_height, double off_model) {
    std::vector<RimEdge> edges = ends_of_cloud(square.rim);
    for (RimEdge& edge : edges) edge.middle.z = edge_height;
    const std::vector<Point> samples = {{3.5, 1.4, sample_height}};
    const std::vector<SampleBeyond> beyond = {
        {SquareRim::edge_at(edges, {3.5, 2, edge_height}), 0}};
    const std::vector<std::uint8_t> found = edges_with_steps(
        model, edges, samples, beyond, {.min_step = 0.3, .farthest = 10, .off_model = off_model});
    EXPECT_EQ(found.size(), edges.size());
    EXPECT_LE(std::accumulate(found.begin(), found.end(), 0U), 1U);
    return found[beyond[0].edge];
  };
  EXPECT_EQ(steps_of(0, 0.2, 1), 0);
  EXPECT_EQ(steps_of(0, 0.4, 1), 1);
  EXPECT_EQ(steps_of(0.4, 0, 1), 1);
  EXPECT_EQ(steps_of(0.5, 0.5, 1), 0);
  EXPECT_EQ(steps_of(0.5, 0.5, 0.4), 1);  // off the model
  const std::vector<RimEdge> edges = ends_of_cloud(square.rim);
  EXPECT_EQ(edges_with_steps(model, edges, {{3.5, 1.4, 5}}, {}, {}),
            std::vector<std::uint8_t>(edges.size(), 0));
}

}  // namespace
}  // namespace cocoon
