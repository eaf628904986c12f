// The energy of a labeling of cells (clean_up_cells.h), evaluated around a few cells.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/clean_up_cells.h"
#include "cocone/side_evidence.h"
#include "delaunay/star_cache.h"
#include "geom/zeroed_array.h"

namespace cocoon {

// Energies are integers, in 2^-20 of a unit: sums are exact, whatever their order.
using Energy = std::int64_t;
Energy to_energy(double units);

class CellEnergy {
 public:
  // All references must outlive the object. `out[c]` = 1: cell c is OUT.
  // `labels`: those of the marking, which decided cells prefer at mark_weight.
  CellEnergy(const Triangulation& triangulation, const Dual& dual, StarCache& stars,
             const IdVector<CellId, CellLabel>& labels, const CleanUpOptions& options,
             IdVector<CellId, std::uint8_t>& out);

  // What it costs that the cell is OUT rather than IN; may be negative.
  void set_preference(CellId c, Energy cost_of_out) {
    own_preference_[c] = cost_of_out - preference_by_label(c);
  }
  // Only of these samples is it a loss that they are not on the surface.
  void want(VertexId v) { wanted_[v] = 1; }
  Energy preference(CellId c) const { return preference_by_label(c) + own_preference_[c]; }

  // The cost of a facet, if its cells are on different sides. Precondition: a finite facet. O(1).
  Energy facet_cost(FacetId f) const;
  // The cost of defects at a vertex, apart from its edges. O(star).
  Energy vertex_cost(VertexId v);
  bool is_unused(VertexId v) const;
  // Would a sample on the surface not be there if these cells changed sides?
  bool leaves_out(std::span<const CellId> cells);
  bool is_idle(VertexId v) {
    return cocoon::is_idle(triangulation_, stars_.star(v), out_, v, idle_);
  }
  // Surface sheets at v beyond the first: what is pinched. O(star).
  std::size_t extra_fans(VertexId v);
  // Surface sheets at the edge ab of facet f. O(degree).
  std::size_t sheets_at(FacetId f, VertexId a, VertexId b) const;

  // How much the energy (without component_cost) grows if these cells change sides; they do not.
  // Precondition: finite cells, all different.
  Energy change(std::span<const CellId> cells);
  void flip(std::span<const CellId> cells);
  // Before each series of floods that shall not meet each other.
  void begin_flood() { ++token_; }
  // Cells of star(v) on the same side as `first` that hang together with it by facets at v.
  void flood_star(VertexId v, CellId first, std::vector<CellId>& cells);

 private:
  struct Edge {
    VertexId a;
    VertexId b;
    FacetId facet;
  };
  Energy preference_by_label(CellId c) const {
    return labels_[c] == CellLabel::out ? -mark_weight_ : mark_weight_;
  }
  void collect(std::span<const CellId> cells);
  Energy sum(std::span<const CellId> cells);

  const Triangulation& triangulation_;
  const Dual& dual_;
  StarCache& stars_;
  const IdVector<CellId, CellLabel>& labels_;
  IdVector<CellId, std::uint8_t>& out_;
  Energy mark_weight_;
  Energy defect_cost_;
  Energy unused_cost_;
  Energy handle_cost_;
  Energy idle_cost_;
  IdleOptions idle_;
  ZeroedArray<CellId, Energy> own_preference_;  // beyond that by the label
  VertexSet wanted_;
  ZeroedArray<CellId, std::uint32_t> stamp_;
  std::uint32_t token_ = 0;
  std::vector<CellId> component_;
  std::vector<VertexId> vertices_;
  std::vector<Edge> edges_;
  std::vector<FacetId> facets_;
};

}  // namespace cocoon
