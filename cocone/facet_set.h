// Sets of vertices and of facets as flags, the currency between the Cocone stages.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

// One flag per vertex.
using VertexSet = IdVector<VertexId, std::uint8_t>;

// A set of facets of one triangulation: four bits per cell, bit i for facet i. A facet is entered
// under both of its ids, so that a question from either side is one read.
class FacetSet {
 public:
  FacetSet() = default;
  explicit FacetSet(std::size_t num_cells) : bits_(num_cells, 0) {}
  // Takes over the four flags of every cell; both ids of a facet must have the same flag.
  explicit FacetSet(IdVector<CellId, std::uint8_t> bits) : bits_(std::move(bits)) {}

  bool contains(FacetId f) const { return ((bits_[cell_of(f)] >> index_of(f)) & 1U) != 0; }
  void insert(const Triangulation& triangulation, FacetId f) { insert(f, triangulation.mirror(f)); }
  // By both of its ids.
  void insert(FacetId f, FacetId mirror) {
    set(f);
    set(mirror);
  }
  void erase(const Triangulation& triangulation, FacetId f) {
    reset(f);
    reset(triangulation.mirror(f));
  }
  // Gives up the flags of all cells.
  IdVector<CellId, std::uint8_t> release() && { return std::move(bits_); }
  // The four flags of a cell, bit i for facet i.
  std::uint8_t bits(CellId c) const { return bits_[c]; }
  // Of the triangulation.
  std::size_t num_cells() const { return bits_.size(); }
  // Number of facets (each counted once). Complexity: O(cells).
  std::size_t size() const;
  // Calls visit(f) once for each facet of the set, with its canonical (smaller) id, in order.
  template <class Visit>
  void for_each(const Triangulation& triangulation, Visit visit) const {
    for_each(triangulation, 0, bits_.size(), visit);
  }
  // The same for those whose canonical id is of one of the cells begin .. end - 1.
  // Block by block without a branch that depends on the flags: half of the guesses would be wrong.
  template <class Visit>
  void for_each(const Triangulation& triangulation, std::size_t begin, std::size_t end,
                Visit visit) const {
    constexpr std::size_t cells_per_block = 256;
    std::array<CellId, cells_per_block> cells;
    std::array<FacetId, 4 * cells_per_block> facets;
    for (std::size_t first = begin; first < end; first += cells_per_block) {
      const std::size_t last = std::min(first + cells_per_block, end);
      std::size_t num_cells = 0;
      for (CellId c(first); c.index() < last; ++c) {
        cells[num_cells] = c;
        num_cells += bits_[c] != 0 ? 1U : 0U;
      }
      std::size_t num_facets = 0;
      for (std::size_t k = 0; k < num_cells; ++k) {
        const Cell& cell = triangulation.cell(cells[k]);
        for (unsigned i = 0; i < 4; ++i) {
          const FacetId f = facet_id(cells[k], static_cast<int>(i));
          const unsigned is_canonical = f <= cell.neighbors[i] ? 1U : 0U;
          facets[num_facets] = f;
          num_facets += (static_cast<unsigned>(bits_[cells[k]]) >> i) & is_canonical;
        }
      }
      for (std::size_t k = 0; k < num_facets; ++k) visit(facets[k]);
    }
  }

  friend bool operator==(const FacetSet&, const FacetSet&) = default;

 private:
  void set(FacetId f) {
    bits_[cell_of(f)] = static_cast<std::uint8_t>(bits_[cell_of(f)] | (1U << index_of(f)));
  }
  void reset(FacetId f) {
    bits_[cell_of(f)] = static_cast<std::uint8_t>(bits_[cell_of(f)] & ~(1U << index_of(f)));
  }

  IdVector<CellId, std::uint8_t> bits_;
};

}  // namespace cocoon
