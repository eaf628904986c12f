// CGAL as a rival: the same work on the same input, timed the way its users run it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bench/rivals/timed_build.h"
#include "bench/stopwatch.h"
#include "geom/point.h"

namespace cocoon::rivals {

// CGAL's Delaunay_triangulation_3 over Exact_predicates_inexact_constructions_kernel, one thread,
// range insertion with its spatial sort. Timed: from a vector of CGAL points in memory to the
// finished triangulation. Not timed: the conversion of `points`, the destruction.
TimedBuild cgal_delaunay(Points points);

// What ref::cell_set_hash says for a triangulation with the cells that CGAL finds. Not timed.
// Precondition: all points different.
std::uint64_t cgal_cell_set_hash(Points points);

struct TimedReplacement {
  bench::Elapsed removal;
  bench::Elapsed insertion;
  std::size_t finite_cells = 0;
};

// In CGAL's triangulation of `points`: removes the vertices at `removed` with remove_cluster,
// inserts the range `inserted`. Timed: these two. Not timed: the build, finding the vertices,
// conversions. Precondition: the removed points are among the points.
TimedReplacement cgal_replace(Points points, Points removed, Points inserted);

}  // namespace cocoon::rivals
