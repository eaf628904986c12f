// Insertion of points by several threads at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "delaunay/delaunay.h"
#include "delaunay/kernel/cavity.h"
#include "delaunay/kernel/cell_pool.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Inserts the vertices order[first..] into the triangulation of order[..first-1], round after
// round, on thread_count(execution) threads, at most VertexClaims::max_holders: what one
// CavityInserter does one by one. `round_ends`:
// where the rounds of `order` end (geom/spatial_order.h); vertices must be numbered along the
// curve. The cells as a set are those of any other order of insertion; their numbers, and the
// counters, depend on how the threads meet. The last element of `points` is no vertex.
// `first_inserter`: the one of the first vertices.
//
// Each round is cut into short runs along the curve. A thread works through neighboring runs from
// one end of its share; a thread that has none left takes one from the other end of the longest
// share. A point is located from the last cell that its thread made; where that has given back its
// claims, as at the beginning of a run, from the inserted vertex next to it along the curve. A
// thread holds the vertices around what it reads and writes (delaunay/kernel/vertex_claims.h);
// where it meets another one it gives the point up and tries again after its run.
//
// Errors: InputError as CavityInserter::insert; Cancelled; then the pool is of no use.
// Complexity: that of one thread, divided by the threads while these are few against the points.
void insert_in_parallel(CellPool& pool, const IdVector<VertexId, Point>& points,
                        const CavityInserter& first_inserter, std::span<const std::uint32_t> order,
                        std::span<const std::size_t> round_ends, std::size_t first,
                        DelaunayCounters& counters, const Execution& execution);

}  // namespace cocoon
