// What a walk reaches without rounds is what it reaches in rounds.
#include "cocone/facets/walk_reach.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// The walk of extract_manifold.h from one half, word for word: all turns go through the cells.
class WalkInRounds {
 public:
  WalkInRounds(const Triangulation& triangulation, const LinkedFacets& candidates,
               const VertexSet& umbrella)
      : triangulation_(triangulation), candidates_(candidates), umbrella_(umbrella) {
    for (Half half = 0; half < 2 * candidates.size(); ++half) {
      half_of_[facet_of_half(candidates, half)] = half;
    }
  }

  std::vector<std::uint8_t> states(Half start) {
    keep(start);
    std::set<Half> frontier = {start};
    while (!frontier.empty()) {
      std::set<Half> met_first;
      std::set<Half> met_later;
      for (const Half half : frontier) turn(half, met_first, met_later);
      for (const Half half : met_later) {
        if (met_first.contains(half) || met_first.contains(other_half(half))) continue;
        if (!is_kept(half)) dropped_.insert(triangle_of_half(half));
      }
      // No test of this file has a candidate that one round meets first from both sides.
      for (const Half half : met_first) EXPECT_FALSE(met_first.contains(other_half(half)));
      for (const Half half : met_first) keep(half);
      frontier = std::move(met_first);
    }
    std::vector<std::uint8_t> states(candidates_.size(), walk_state::open);
    for (const std::uint32_t t : dropped_) states[t] = walk_state::dropped;
    for (const Half half : kept_) states[triangle_of_half(half)] = walk_state::kept[half & 1U];
    return states;
  }
  bool met_back() const { return met_back_; }

 private:
  bool is_kept(Half half) const { return kept_.contains(half) || kept_.contains(other_half(half)); }
  void keep(Half half) { kept_.insert(half); }

  void turn(Half half, std::set<Half>& met_first, std::set<Half>& met_later) {
    const Halfedge first = 3 * triangle_of_half(half);
    for (Halfedge halfedge = first; halfedge < first + 3; ++halfedge) {
      const auto [a, b] = candidates_.ends(halfedge);
      if (umbrella_[a] == 0 && umbrella_[b] == 0) continue;
      bool is_first = true;
      for (const Half met : met_around(half, a, b)) {
        if (dropped_.contains(triangle_of_half(met))) continue;
        met_back_ = met_back_ || (is_first && kept_.contains(other_half(met)));
        if (!is_first) met_later.insert(met);
        if (is_first && !is_kept(met)) met_first.insert(met);
        is_first = false;
      }
    }
  }

  std::vector<Half> met_around(Half half, VertexId a, VertexId b) const {
    std::vector<Half> met;
    const FacetId back = triangulation_.mirror(facet_of_half(candidates_, half));
    FacetId f = other_facet_at_edge(triangulation_, facet_of_half(candidates_, half), a, b);
    for (; f != back; f = other_facet_at_edge(triangulation_, triangulation_.mirror(f), a, b)) {
      if (candidates_.set.contains(f)) met.push_back(half_of_.at(f));
    }
    return met;
  }

  const Triangulation& triangulation_;
  const LinkedFacets& candidates_;
  const VertexSet& umbrella_;
  std::map<FacetId, Half> half_of_;
  std::set<Half> kept_;
  std::set<std::uint32_t> dropped_;
  bool met_back_ = false;
};

struct Candidates {
  explicit Candidates(const std::vector<Point>& points)
      : stages(points),
        pruned(prune_sharp_edges(
            stages.triangulation,
            candidate_triangles(stages.triangulation, stages.cocones, stages.labels().boundary))) {}

  Half start() const {
    for (Half t = 0; t < pruned.left.size(); ++t) {
      if (stages.triangulation.is_infinite(cell_of(pruned.left.mirrors[t]))) return 2 * t + 1;
    }
    return 0;
  }

  Stages stages;
  PrunedCandidates pruned;
};

// Returns whether no rounds were needed.
bool expect_states_of_rounds(const Candidates& candidates, Half start) {
  const Triangulation& triangulation = candidates.stages.triangulation;
  const auto& [left, umbrella, count, pruned, umbrellas] = candidates.pruned;
  const auto reached = walk_reach(triangulation, left, umbrella, start);
  EXPECT_EQ(walk_reach(triangulation, left, umbrella, start, {.threads = 3}), reached);
  if (!reached) return false;
  WalkInRounds walk(triangulation, left, umbrella);
  EXPECT_EQ(*reached, walk.states(start));
  EXPECT_FALSE(walk.met_back());
  return true;
}

TEST(WalkReach, OfSmoothSurfacesNeedsNoRounds) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Candidates sphere(shapes::sphere(700, seed));
    EXPECT_TRUE(expect_states_of_rounds(sphere, sphere.start()));
    EXPECT_TRUE(expect_states_of_rounds(sphere, other_half(sphere.start())));
    const Candidates torus(shapes::random_torus(900, 0.4, seed));
    EXPECT_TRUE(expect_states_of_rounds(torus, torus.start()));
  }
}

// Where four samples nearly lie on a circle, all facets of a flat tetrahedron are candidates.
TEST(WalkReach, PassesTheBacksOfFlatTetrahedra) {
  const Candidates candidates(gallery::bumpy_sphere(4000));
  const std::vector<Halfedge>& steep = candidates.pruned.left.steep;
  EXPECT_TRUE(std::any_of(steep.begin(), steep.end(), [&](Halfedge halfedge) {
    return candidates.pruned.left.has_three_triangles(halfedge);
  }));
  EXPECT_TRUE(expect_states_of_rounds(candidates, candidates.start()));
}

// Whoever walks there comes back on the other side.
TEST(WalkReach, LeavesOneSidedSurfacesToRounds) {
  const Candidates strip(shapes::moebius_strip(80, 9, 0.1, 3));
  EXPECT_FALSE(expect_states_of_rounds(strip, strip.start()));
}

TEST(WalkReach, LeavesWhatContradictsItselfToRounds) {
  std::size_t without_rounds = 0;
  constexpr std::size_t tries = 20;
  for (std::uint64_t seed = 0; seed < tries; ++seed) {
    const Candidates noisy(shapes::noisy_sphere(400, 0.002 * static_cast<double>(seed), seed));
    without_rounds += expect_states_of_rounds(noisy, noisy.start()) ? 1U : 0U;
  }
  EXPECT_GT(without_rounds, 0U);
  EXPECT_LT(without_rounds, tries);
}

}  // namespace
}  // namespace cocoon
