// CGAL as a rival: the same work on the same input, timed the way its users run it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "bench/rivals/timed_build.h"
#include "bench/stopwatch.h"
#include "geom/point.h"

namespace cocoon::rivals {

// CGAL's Delaunay_triangulation_3 over Exact_predicates_inexact_constructions_kernel, one thread,
// range insertion with its spatial sort. Timed: from a vector of CGAL points in memory to the
// finished triangulation. Not timed: the conversion of `points`, the destruction.
TimedBuild cgal_delaunay(Points points);

struct TimedReplacement {
  bench::Elapsed removal;
  bench::Elapsed insertion;
};

// CGAL's triangulation of the same kind, which changes.
class CgalDynamicDelaunay {
 public:
  explicit CgalDynamicDelaunay(Points points);
  ~CgalDynamicDelaunay();
  CgalDynamicDelaunay(CgalDynamicDelaunay&&) noexcept;
  CgalDynamicDelaunay& operator=(CgalDynamicDelaunay&&) noexcept;

  // Removes the vertices at `removed` with remove_cluster, then inserts the range `inserted`.
  // Timed: these two. Not timed: finding the vertices, conversions. Precondition: the removed
  // points are vertices.
  TimedReplacement replace(Points removed, Points inserted);
  // As place_set_hash() of our triangulation (place_set_hash.h), if the cells are the same.
  std::uint64_t place_set_hash() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cocoon::rivals
