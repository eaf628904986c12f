#include "cocone/steps/find_surface.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

// A dome has a rim: boundary samples, and candidates that are pruned.
class FindSurface : public testing::Test {
 protected:
  std::vector<Point> points_ = shapes::cut_sphere(500, 0.2, 3);
  Stages stages_{points_};
  ReconstructOptions options_ = effective_options({});
  ReconstructInput input_{stages_.triangulation, points_, options_};
};

TEST_F(FindSurface, FindsWhatTheStagesDoByHand) {
  ReconstructCounters counters;
  const FoundSurface found = find_surface(input_, counters, nullptr, {});
  const BoundarySamples labels = stages_.labels();
  EXPECT_EQ(found.boundary.boundary, labels.boundary);
  EXPECT_EQ(found.poles.normals, stages_.poles.normals);
  EXPECT_EQ(found.surface.triangles.set, stages_.surface(labels).set);
  EXPECT_EQ(counters.boundary_samples, labels.count);
  EXPECT_GT(labels.count, 10U);
  EXPECT_EQ(counters.surface_triangles, found.surface.halves.size());
  EXPECT_GE(counters.candidates, counters.surface_triangles + counters.pruned);
}

TEST_F(FindSurface, SetsAndHeightsAreKeptForWhoGoesOn) {
  ReconstructCounters counters;
  EXPECT_TRUE(find_surface(input_, counters, nullptr, {}).poles.heights.empty());
  ReconstructStages kept;
  const FoundSurface found = find_surface(input_, counters, &kept, {});
  EXPECT_EQ(found.poles.heights, stages_.poles.heights);
  const FacetSet candidates =
      candidate_triangles(stages_.triangulation, stages_.cocones, found.boundary.boundary);
  EXPECT_EQ(kept.candidates, candidates);
  EXPECT_EQ(kept.umbrella, prune_sharp_edges(stages_.triangulation, candidates).umbrella);
}

TEST_F(FindSurface, WhatIsKnownUpToPruningIsWalkedAlone) {
  ReconstructCounters counters;
  ReconstructStages kept;
  const FoundSurface expected = find_surface(input_, counters, &kept, {});
  KnownCandidates known;
  known.normals = expected.poles.normals;
  known.boundary = expected.boundary.boundary;
  known.umbrella = kept.umbrella;
  known.left = prune_sharp_edges(stages_.triangulation,
                                 candidate_triangles(stages_.triangulation, stages_.cocones,
                                                     expected.boundary.boundary))
                   .left;
  known.counters = counters;
  known.counters.surface_triangles = 0;  // which only the walk tells
  ReconstructCounters again;
  const FoundSurface found = find_surface(input_, std::move(known), again, {});
  EXPECT_EQ(found.surface.triangles.set, expected.surface.triangles.set);
  EXPECT_EQ(found.surface.halves, expected.surface.halves);
  EXPECT_EQ(found.boundary.interior(), expected.boundary.interior());
  EXPECT_EQ(again.surface_triangles, counters.surface_triangles);
  EXPECT_EQ(again.candidates, counters.candidates);
}

}  // namespace
}  // namespace cocoon
