// The cells around each vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

class VertexStars {
 public:
  VertexStars() = default;
  VertexStars(std::vector<std::uint32_t> offsets, std::vector<CellId> cells)
      : offsets_(std::move(offsets)), cells_(std::move(cells)) {}

  std::size_t num_vertices() const { return offsets_.empty() ? 0 : offsets_.size() - 1; }
  // All cells, finite and infinite, that have v as a vertex, in increasing order. O(1).
  std::span<const CellId> star(VertexId v) const {
    return std::span(cells_).subspan(offsets_[v.index()],
                                     offsets_[v.index() + 1] - offsets_[v.index()]);
  }

 private:
  std::vector<std::uint32_t> offsets_;  // one per vertex and one past the end
  std::vector<CellId> cells_;
};

// Lists the star of every finite vertex. Complexity: O(cells), parallel; 4 bytes per corner of a
// cell.
VertexStars vertex_stars(const Triangulation& triangulation, const Execution& execution = {});

// Of every star only the infinite cells; empty for vertices inside the hull.
// Complexity: O(vertices + infinite cells), parallel.
VertexStars hull_stars(const Triangulation& triangulation, const Execution& execution = {});

}  // namespace cocoon
