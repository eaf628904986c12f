// The stage "points -> Delaunay triangulation".
#pragma once

#include <cstddef>
#include <cstdint>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

struct DelaunayOptions {
  // Seed of the insertion rounds. The triangulation does not depend on it; running time does.
  std::uint64_t seed = 1;
};

// What the build did.
struct DelaunayCounters {
  std::size_t walk_steps = 0;      // cells entered by point location
  std::size_t conflict_tests = 0;  // cells tested against a new point's position
  std::size_t cells_created = 0;   // over the whole build
  std::size_t cells_deleted = 0;
  std::size_t wide_inspheres = 0;       // conflict tests decided by pairs of doubles
  std::size_t exact_inspheres = 0;      // that these left open, too
  std::size_t perturbed_inspheres = 0;  // known by either to be zero, left to the perturbation
  // With several threads:
  std::size_t retries = 0;      // points put off, since another thread was at work there
  std::size_t stolen_runs = 0;  // runs of points that a thread without work took from another

  DelaunayCounters& operator+=(const DelaunayCounters& other);
};

struct DelaunayResult {
  Triangulation triangulation;
  DelaunayCounters counters;
};

// The 3D Delaunay triangulation of `points`, cospherical ties broken by the lexicographic
// perturbation of geom/perturbation.h: a function of the set of points alone. Equal points become
// one vertex. Vertices are numbered along a Hilbert curve (geom/spatial_order.h), the same for
// every order of the input; so are the cells of a build on one thread. With more threads their
// numbers depend on how the threads meet, and so do the counters: canonical_order numbers the cells
// by the point set alone whatever the history. Fewer than 3 000 different points are inserted on
// one thread (delaunay/kernel/parallel_insertion.h says how many do it). Progress is reported as
// "delaunay".
// Errors: InputError if a coordinate is not finite (names the first such point), if there are more
// points than 32-bit ids can number (2^32 - 3), or if there would be more than 2^30 - 1 cells (some
// 150 million points); DegenerateInput if there are fewer than four different points, or all points
// are coplanar.
// Complexity: O(n log n) expected for points on surfaces and in volumes, O(n^2) in the worst case.
// Source: Bowyer 1981 and Watson 1981 (insertion), Amenta, Choi & Rote 2003 (insertion rounds).
DelaunayResult delaunay(Points points, const DelaunayOptions& options = {},
                        const Execution& execution = {});

}  // namespace cocoon
