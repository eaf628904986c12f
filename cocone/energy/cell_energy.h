// The energy of a labeling of cells (clean_up_cells.h), evaluated around a few cells.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cocone/clean_up_cells.h"
#include "cocone/energy/ball_cosines.h"
#include "cocone/energy/idle_samples.h"
#include "cocone/energy/star_parts.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/star_cache.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"

namespace cocoon {

// Energies are integers, in 2^-20 of a unit: sums are exact, whatever their order. So that they do
// not overflow, one cost counts as 2^20 units at most, infinity too. NaN is 0.
using Energy = std::int64_t;
inline constexpr Energy most_energy = Energy{1} << 40;
Energy to_energy(double units);

class CellEnergy {
 public:
  // All references must outlive the object. `out[c]` = 1: cell c is OUT.
  // Decided cells prefer their labels in `marks` at mark_weight; those known beforehand keep them.
  CellEnergy(const Triangulation& triangulation, BallCosines& cosines, StarCache& stars,
             SpacingCache& spacings, const CellMarks& marks, const CleanUpOptions& options,
             IdVector<CellId, std::uint8_t>& out);

  // What it costs that the cell is OUT rather than IN; may be negative.
  void set_preference(CellId c, Energy cost_of_out) {
    own_preference_[c] = cost_of_out - preference_by_label(c);
  }
  // Only of these samples is it a loss that they are not on the surface.
  void want(VertexId v) { set_wanted(v, 1); }
  void leave_out(VertexId v) { set_wanted(v, 0); }
  bool is_wanted(VertexId v) const { return wanted_[v] != 0; }
  Energy preference(CellId c) const { return preference_by_label(c) + own_preference_[c]; }

  // The cost of a facet, if its cells are on different sides. Precondition: a finite facet. O(1),
  // but for spacings that were never asked for; remembered.
  Energy facet_cost(FacetId f) {
    const std::uint32_t known = facet_costs_[triangulation_.canonical(f)];
    return known != 0 ? known - 1 : ask_facet_cost(f);
  }
  // Computes ahead what the facets of these finite cells cost, but for those at flat ones, on all
  // threads, if there are so many that all stars are listed; and the spacings of their samples.
  // Precondition: what the BallCosines tell of these cells and those beside them is known.
  void prepare_facet_costs(std::span<const CellId> cells, const Execution& execution);
  // The cost of defects at a vertex, apart from its edges. O(star).
  Energy vertex_cost(VertexId v);
  // The same if these cells changed sides; they do not. O(star + cells).
  Energy vertex_cost_after(VertexId v, std::span<const CellId> cells);
  bool is_unused(VertexId v) const;
  // Would a sample on the surface not be there if these cells changed sides?
  bool leaves_out(std::span<const CellId> cells);
  // Is the sample idle (idle_samples.h)? O(star) the first time since the last flip at it, then
  // O(1). Threads may ask about different samples if they may share the stars.
  bool is_idle(VertexId v);
  // Is that known, so that is_idle() is O(1)?
  bool knows_idle(VertexId v) const {
    return at_[v].idle != 0 && at_[v].idle / 2 >= at_[v].changed;
  }
  // Asks ahead about those of which it is not known: on all threads if they may share the stars.
  void ask_idle(std::span<const VertexId> samples, const Execution& execution);
  // Tells that all vertices but those in doubt are on the surface, which is not pinched there: so
  // nobody needs to look until a flip at one. Before the first flip. O(1).
  void know_flawless_elsewhere() { flawless_elsewhere_ = true; }
  void doubt(VertexId v) { at_[v].doubtful = 1; }
  // Surface sheets at v beyond the first: what is pinched. O(star).
  std::size_t extra_fans(VertexId v);

  // How much the energy (without component_cost) grows if these cells change sides; they do not.
  // If that is more than `limit`, some number above the limit. Told from the facets, edges and
  // vertices of the set. Precondition: finite cells, all different. Complexity: O(stars).
  Energy change(std::span<const CellId> cells, Energy limit = std::numeric_limits<Energy>::max());
  // A bound that no change falls below, told from the facets and edges: of cell c; of cells on one
  // side. Vertices count as if the flip healed whatever is wrong there. If a set's bound is more
  // than `limit`, some bound above the limit. O(1) for each cell and vertex that was asked about
  // since the last flip at it.
  Energy least_change(CellId c);
  Energy least_change(std::span<const CellId> cells,
                      Energy limit = std::numeric_limits<Energy>::max());
  // The same for one cell alone, and with the finite cell behind its facet i, if both are on one
  // side: these have much in common.
  class BoundsOfCell;
  // Is a facet of the cell on the surface? O(1).
  bool is_at_surface(CellId c) const;
  void flip(std::span<const CellId> cells);
  // The parts into which the surface divides the cells at v. O(star).
  std::vector<std::vector<CellId>> parts_of_star(VertexId v) { return parts_.list(v); }

 private:
  bool is_on_surface(FacetId f) const {
    return out_[triangulation_.neighbor(cell_of(f), index_of(f))] != out_[cell_of(f)];
  }
  // How a cell lies in the surface before it changes sides, and by how much the energy grows then,
  // but for what happens at its vertices.
  struct Place {
    Energy change;
    std::array<int, 6> sheets;  // at its edges (edge_number)
    std::uint32_t state;
    std::array<bool, 4> surface;  // facets
  };
  // What is remembered of a vertex: each until cells at it change sides for good.
  struct AtVertex {
    std::uint32_t changed;      // the state since the last flip at the vertex
    std::uint32_t parts;        // of the star
    std::uint32_t parts_state;  // 0: never counted
    std::uint32_t idle;         // 2 * state + 1 if idle in that state
    std::uint32_t doubtful;     // 1: whoever wants to know has to look
    Energy least;               // the least by which its cost can change
    std::uint32_t least_state;  // 0: not known
  };
  void set_wanted(VertexId v, std::uint8_t wanted) {
    wanted_[v] = wanted;
    at_[v].least_state = 0;
  }
  Energy ask_facet_cost(FacetId f);
  // What a facet costs for being longer than the samples at it lie apart, in units.
  double stretch(FacetId f);
  // More than all that could be won.
  static constexpr Energy known_weight = 4 * most_energy;
  Energy preference_by_label(CellId c) const {
    const Energy weight = is_known(marks_, c) ? known_weight : mark_weight_;
    return marks_.labels[c] == CellLabel::out ? -weight : weight;
  }
  Energy change_together(const Place& first, FacetId f);
  Place place_of(CellId c);
  const Place& place_now(CellId c);
  Energy edge_change(int sheets, int more) const;
  std::size_t parts_now(VertexId v);
  Energy least_vertex_change(VertexId v) {
    const AtVertex& here = at_[v];
    if (here.least_state != 0 && here.least_state >= here.changed) return here.least;
    return ask_least_vertex_change(v);
  }
  Energy ask_least_vertex_change(VertexId v);
  void list_boundary(std::span<const CellId> cells);
  Energy boundary_change(std::span<const CellId> cells);
  Energy edge_changes();
  Energy star_cost(VertexId v, std::size_t parts) const;
  void turn(std::span<const CellId> cells);
  void list_vertices(std::span<const CellId> cells);
  int sheets_at(CellId c, int i, int j, int most) const;
  // What it costs that a vertex is on the surface rather than not: a vertex for Euler.
  Energy cost_of_use(VertexId v) const {
    return -half_handle_cost_ - (wanted_[v] != 0 ? unused_cost_ : 0);
  }
  bool would_be_idle(VertexId v) {
    return cocoon::is_idle(triangulation_, stars_.star(v), out_, v, idle_);
  }

  const Triangulation& triangulation_;
  BallCosines& cosines_;
  StarCache& stars_;
  SpacingCache& spacings_;
  const CellMarks& marks_;
  IdVector<CellId, std::uint8_t>& out_;
  double stretch_cost_;
  double stretch_ratio_;
  Energy mark_weight_;
  Energy defect_cost_;
  Energy unused_cost_;
  Energy half_handle_cost_;
  Energy idle_cost_;
  IdleOptions idle_;
  ZeroedArray<CellId, Energy> own_preference_;  // beyond that by the label
  VertexSet wanted_;
  StarParts parts_;
  ZeroedArray<FacetId, std::uint32_t> facet_costs_;  // 1 + that, by canonical ids; 0: not known
  ZeroedArray<CellId, Place> places_now_;
  ZeroedArray<VertexId, AtVertex> at_;
  ZeroedArray<CellId, std::uint8_t> taken_;     // scratch, zero between questions
  ZeroedArray<VertexId, std::uint8_t> listed_;  // likewise
  std::uint32_t state_ = 1;                     // grows with every flip
  bool flawless_elsewhere_ = false;
  std::vector<VertexId> vertices_;
  // A facet that appears (1) or goes (-1) at an edge, where there are so many sheets now.
  struct FacetAtEdge {
    std::array<VertexId, 2> edge;
    int sheets;
    int more;
  };
  std::vector<FacetAtEdge> facets_at_edges_;
  std::vector<FacetId> boundary_;  // of a set of cells, as seen from these
};

// Valid until the next flip.
class CellEnergy::BoundsOfCell {
 public:
  BoundsOfCell(CellEnergy& energy, CellId c)
      : energy_(energy), cell_(c), place_(energy.place_now(c)), at_vertices_(0) {
    for (const VertexId v : energy.triangulation_.cell(c).vertices) {
      at_vertices_ += energy.least_vertex_change(v);
    }
  }
  Energy alone() const { return place_.change + at_vertices_; }
  Energy with(int i) const {
    const FacetId f = facet_id(cell_, i);
    const VertexId beyond =
        energy_.triangulation_.opposite_vertex(energy_.triangulation_.mirror(f));
    return energy_.change_together(place_, f) + at_vertices_ + energy_.least_vertex_change(beyond);
  }

 private:
  CellEnergy& energy_;
  CellId cell_;
  const Place& place_;
  Energy at_vertices_;
};

inline Energy CellEnergy::least_change(CellId c) { return BoundsOfCell(*this, c).alone(); }

}  // namespace cocoon
