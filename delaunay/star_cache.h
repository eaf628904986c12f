// The cells around some of the vertices, found when asked for: for stages that look at few stars.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/circulate.h"
#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// Not to be shared by threads, but see expect(): a question may change it. vertex_stars() lists all
// stars at once.
class StarCache {
 public:
  // Keeps a reference, which must outlive the object. O(1); the first question costs O(cells),
  // parallel.
  explicit StarCache(const Triangulation& triangulation, const Execution& execution = {})
      : StarCache(triangulation, nullptr, execution) {}
  // Overload for callers that know a cell at each vertex (`cell_at`, which must stay valid): the
  // first query then costs O(vertices) instead of O(cells). nullptr: not known.
  StarCache(const Triangulation& triangulation, const IdVector<VertexId, CellId>* cell_at,
            const Execution& execution)
      : triangulation_(triangulation), cell_at_(cell_at), execution_{execution.threads} {}

  // All cells, finite and infinite, that have v as a vertex, in increasing order. Valid as long as
  // the object. O(star log star) the first time, then O(1). When a sixteenth of all stars (and
  // some) has been asked for, or so many that they have a third as many cells as there are, all
  // are listed: O(cells), parallel, once.
  std::span<const CellId> star(VertexId v);

  // All cells that have one of the vertices, increasing. Complexity: as their stars, or O(cells) if
  // they are many.
  std::vector<CellId> cells_at(std::span<const VertexId> vertices);

  // Announces that so many stars will be asked for: if it pays, all are listed now. True if they
  // are: questions then change nothing, so threads may share the object. Complexity: O(1) or
  // O(cells).
  bool expect(std::size_t count);

 private:
  // So many stars that a pass over the cells is the shorter way.
  bool are_many(std::size_t count) const;
  // The same of their cells, counted at each vertex.
  bool are_many_cells(std::size_t count) const;
  void begin();
  void find_first_cells();
  std::vector<CellId> collect(VertexId v);

  const Triangulation& triangulation_;
  const IdVector<VertexId, CellId>* cell_at_;
  Execution execution_;                      // nobody is told of its progress
  IdVector<VertexId, CellId> first_cell_;    // if there are none
  IdVector<VertexId, std::uint32_t> place_;  // in stars_
  std::deque<std::vector<CellId>> stars_;
  std::size_t cells_of_stars_ = 0;  // with multiplicity
  std::optional<VertexStars> all_;
  ZeroedArray<CellId, std::uint8_t> seen_;  // scratch, zero between questions
};

// Calls visit(v) for each of the vertices, whose stars are asked for ahead (visit_stars): on all
// threads if these may share the cache (StarCache::expect), else on one. What visit() changes must
// be of v alone. Complexity: as many questions as vertices.
template <class Visit>
void visit_stars_in_parallel(const Triangulation& triangulation, StarCache& stars,
                             std::span<const VertexId> vertices, const Execution& execution,
                             const Visit& visit) {
  constexpr std::size_t vertices_per_chunk = 1024;
  const Execution shared = stars.expect(vertices.size()) ? execution : Execution{};
  const auto vertex_at = [&](std::size_t k) { return vertices[k]; };
  parallel_chunks(shared, vertices.size(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    visit_stars(triangulation, stars, begin, end, vertex_at,
                                [&](std::size_t k) { visit(vertices[k]); });
                  });
}

}  // namespace cocoon
