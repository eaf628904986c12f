#include "cocone/certified_surface.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "cocone/cocones.h"
#include "cocone/linked_facets.h"
#include "cocone/prune_patch.h"
#include "cocone/umbrella.h"
#include "delaunay/circulate.h"
#include "geom/circumsphere.h"
#include "geom/triangle_normal.h"

namespace cocoon {
namespace {

// Flags of vertices.
constexpr unsigned on_hull = 1;
constexpr unsigned taken_in = 2;
constexpr unsigned both_conditions = 4;
// Flags of cells.
constexpr unsigned candidate_facets = 15;
constexpr unsigned exact_center = 16;
constexpr unsigned facet_center = 32;
constexpr unsigned infinite = 64;
constexpr unsigned finite = 128;

std::size_t bits_of(unsigned flags) { return static_cast<std::size_t>(std::popcount(flags)); }

using Corners = std::array<Point, 3>;

Corners sorted_corners(const TriangulationView& view, FacetId f) {
  const auto [a, b, c] = view.facet_vertices(f);
  Corners corners{view.point(a), view.point(b), view.point(c)};
  std::sort(corners.begin(), corners.end());
  return corners;
}

// How the Voronoi vertex, or ray, of a cell is obtained, as voronoi_dual counts it.
unsigned center_flags(const TriangulationView& view, CellId c) {
  const auto& [v0, v1, v2, v3] = view.cell(c).vertices;
  const Point& p0 = view.point(v0);
  const Point& p1 = view.point(v1);
  const Point& p2 = view.point(v2);
  if (v3 == infinite_vertex) return triangle_normal(p0, p1, p2).exact ? exact_center : 0;
  switch (circumcenter(p0, p1, p2, view.point(v3)).level) {
    case CenterLevel::doubles:
      return 0;
    case CenterLevel::exact:
      return exact_center;
    case CenterLevel::facet:
    case CenterLevel::centroid:
      return facet_center;
  }
  return 0;
}

}  // namespace

// What is found out about one part of the triangulation; ids are those of the patch.
struct CertifiedSurface::Examination {
  LocalPatch patch;
  VertexSet dirty;  // its star, or the normal of a sample in it, may be new
  Dual dual;
  Poles poles;
  Cocones cocones;
  IdVector<VertexId, SampleState> states;
  VertexSet taken;
  FacetSet candidates;  // before pruning
  FacetSet left;        // after it
  IdVector<CellId, std::uint8_t> outer;
  FacetSet surface;

  const Triangulation& triangulation() const { return patch.triangulation; }
  bool has_dirty_vertex(FacetId f) const {
    for (const VertexId v : triangulation().facet_vertices(f)) {
      if (v != infinite_vertex && dirty[v] != 0) return true;
    }
    return false;
  }
  bool is_outer(FacetId f) const { return ((outer[cell_of(f)] >> index_of(f)) & 1U) != 0; }
  void set_outer(FacetId f) {
    outer[cell_of(f)] = static_cast<std::uint8_t>(outer[cell_of(f)] | (1U << index_of(f)));
  }

  void find_normals(const IdVector<VertexId, Vec3>& known, const Execution& execution);
  bool all_interior() const;
  void find_candidates(const IdVector<CellId, std::uint8_t>& known);
  void take_outer_halves(const IdVector<CellId, std::uint8_t>& known);
  FacetId first_met(FacetId f, VertexId third) const;
  bool grow(std::vector<FacetId> open);
  FacetId first_hull_candidate() const;
  std::vector<FacetId> halves() const;
  bool is_one_umbrella_everywhere(const GoodVertexOptions& options, const Execution& execution);
};

void CertifiedSurface::Examination::find_normals(const IdVector<VertexId, Vec3>& known,
                                                 const Execution& execution) {
  dual = voronoi_dual(triangulation(), execution);
  poles = compute_poles(triangulation(), dual, execution);
  for (const VertexId v : triangulation().vertices()) {
    if (patch.is_core[v] != 0) continue;
    poles.normals[v] = known[patch.vertex_in_whole[v]];
    poles.degenerate[v] = 0;
  }
}

bool CertifiedSurface::Examination::all_interior() const {
  for (const VertexId v : triangulation().vertices()) {
    if (patch.is_core[v] == 0 || states[v] == SampleState::interior) continue;
    if (states[v] == SampleState::ratio_fails || taken[v] == 0) return false;
  }
  return true;
}

// All three corners vote. Facets without a dirty vertex are what they were.
void CertifiedSurface::Examination::find_candidates(const IdVector<CellId, std::uint8_t>& known) {
  IdVector<CellId, std::uint8_t> bits(triangulation().num_cells(), 0);
  for (const CellId c : bits.ids()) {
    if (patch.slot_of_cell[c].index() >= known.size()) continue;
    const unsigned before = known[patch.slot_of_cell[c]] & candidate_facets;
    for (int i = 0; i < 4; ++i) {
      const unsigned bit = 1U << i;
      if ((before & bit) != 0 && !has_dirty_vertex(facet_id(c, i))) {
        bits[c] = static_cast<std::uint8_t>(bits[c] | bit);
      }
    }
  }
  candidates = FacetSet(std::move(bits));
  for (std::size_t k = 0; k < cocones.facets.size(); ++k) {
    const FacetId f = cocones.facets[k];
    if (cocones.rows[k] == (15U & ~(1U << index_of(f))) && has_dirty_vertex(f)) {
      candidates.insert(triangulation(), f);
    }
  }
}

void CertifiedSurface::Examination::take_outer_halves(const IdVector<CellId, std::uint8_t>& known) {
  outer = IdVector<CellId, std::uint8_t>(triangulation().num_cells(), 0);
  for (const CellId c : outer.ids()) {
    if (patch.slot_of_cell[c].index() >= known.size()) continue;
    const std::uint8_t before = known[patch.slot_of_cell[c]];
    if (before == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (((before >> i) & 1) != 0 && !has_dirty_vertex(f)) set_outer(f);
    }
  }
}

// Turns about the edge of f opposite `third`, from f's side, to the first candidate: the half of it
// that is met; none if there is no other. Precondition: the edge has a core vertex.
FacetId CertifiedSurface::Examination::first_met(FacetId f, VertexId third) const {
  const Triangulation& t = triangulation();
  const FacetId back = t.mirror(f);
  for (;;) {
    const FacetId g = facet_id(cell_of(f), index_of_vertex(t.cell(cell_of(f)), third));
    if (g == back) return {};
    if (left.contains(g)) return g;
    third = t.opposite_vertex(f);
    f = t.mirror(g);
  }
}

// Turns about the edges of outer halves and adds what is met, until the surface is closed at the
// core. False if it meets what cannot be.
bool CertifiedSurface::Examination::grow(std::vector<FacetId> open) {
  const Triangulation& t = triangulation();
  while (!open.empty()) {
    const FacetId f = open.back();
    open.pop_back();
    const std::array<VertexId, 3> v = t.facet_vertices(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool complete =
          patch.is_core[v[(i + 1) % 3]] != 0 || patch.is_core[v[(i + 2) % 3]] != 0;
      if (!complete) continue;
      const FacetId met = first_met(f, v[i]);
      if (met.is_none() || is_outer(t.mirror(met))) return false;
      if (is_outer(met)) continue;
      if (!has_dirty_vertex(met)) return false;
      set_outer(met);
      open.push_back(met);
    }
  }
  return true;
}

FacetId CertifiedSurface::Examination::first_hull_candidate() const {
  const Triangulation& t = triangulation();
  FacetId first;
  for (const CellId c : t.infinite_cells()) {
    const FacetId f = facet_id(c, 3);
    if (!left.contains(f)) continue;
    if (first.is_none() || sorted_corners(t, f) < sorted_corners(t, first)) first = f;
  }
  return first;
}

std::vector<FacetId> CertifiedSurface::Examination::halves() const {
  std::vector<FacetId> list;
  for (const CellId c : outer.ids()) {
    for (int i = 0; outer[c] != 0 && i < 4; ++i) {
      if (is_outer(facet_id(c, i))) list.push_back(facet_id(c, i));
    }
  }
  return list;
}

bool CertifiedSurface::Examination::is_one_umbrella_everywhere(const GoodVertexOptions& options,
                                                               const Execution& execution) {
  const Triangulation& t = triangulation();
  surface = FacetSet(t.num_cells());
  for (const FacetId f : halves()) surface.insert(t, f);
  const VertexSet none(t.num_vertices(), 0);
  const GoodVertices good =
      good_vertices(link_facets(t, surface, execution), none, options, execution);
  for (const VertexId v : t.vertices()) {
    if (patch.is_core[v] != 0 && good.good[v] == 0) return false;
  }
  return true;
}

// --- Whole and part --------------------------------------------------------------------------

void CertifiedSurface::clear() { *this = CertifiedSurface(options_); }

bool CertifiedSurface::certify(const DynamicDelaunay& delaunay, const Execution& execution) {
  clear();
  std::vector<VertexId> all;
  for (const VertexId v : id_range<VertexId>(delaunay.num_vertex_slots())) {
    if (delaunay.contains(v)) all.push_back(v);
  }
  exists_ = !all.empty() && examine(delaunay, all, all, execution);
  if (!exists_) clear();
  return exists_;
}

bool CertifiedSurface::update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                              const Execution& execution) {
  forget(change);
  // The vertices of new cells, and those next to them.
  const TriangulationView view = delaunay.view();
  std::vector<VertexId> dirty;
  std::vector<VertexId> core;
  const auto append_vertices = [&](CellId c, std::vector<VertexId>& list) {
    for (const VertexId v : view.cell(c).vertices) {
      if (v != infinite_vertex) list.push_back(v);
    }
  };
  const auto make_set = [](std::vector<VertexId>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  for (const CellId c : change.created) append_vertices(c, dirty);
  make_set(dirty);
  const LocalPatch stars = patches_.build(delaunay, dirty);
  core = stars.vertex_in_whole.raw();
  make_set(core);
  exists_ = examine(delaunay, std::move(core), dirty, execution);
  if (!exists_) clear();
  return exists_;
}

// What went takes its counts along. Slots of deleted cells may already hold new ones.
void CertifiedSurface::forget(const DelaunayChange& change) {
  for (const CellId c : change.deleted) set_cell(c, 0, 0, 0);
  for (const VertexId v : change.removed) set_vertex(v, 0);
}

// Both keep the counts.
void CertifiedSurface::set_cell(CellId c, std::uint8_t flags, std::uint8_t outer,
                                std::uint8_t pruned) {
  const auto tally = [&](std::size_t step) {  // 1, or its negative
    candidates_ += step * bits_of(cell_flags_[c] & candidate_facets);
    outer_halves_ += step * bits_of(outer_[c]);
    pruned_halves_ += step * bits_of(pruned_[c]);
    exact_centers_ += step * bits_of(cell_flags_[c] & exact_center);
    facet_centers_ += step * bits_of(cell_flags_[c] & facet_center);
    finite_cells_ += step * bits_of(cell_flags_[c] & finite);
  };
  tally(static_cast<std::size_t>(-1));
  cell_flags_[c] = flags;
  outer_[c] = outer;
  pruned_[c] = pruned;
  tally(1);
}

void CertifiedSurface::set_vertex(VertexId v, std::uint8_t flags) {
  const auto tally = [&](std::size_t step) {
    hull_vertices_ += step * bits_of(vertex_flags_[v] & on_hull);
    taken_in_ += step * bits_of(vertex_flags_[v] & taken_in);
  };
  tally(static_cast<std::size_t>(-1));
  vertex_flags_[v] = flags;
  tally(1);
}

bool CertifiedSurface::examine(const DynamicDelaunay& delaunay, std::vector<VertexId> core,
                               std::span<const VertexId> dirty, const Execution& execution) {
  const Execution quiet{execution.threads, nullptr};
  normals_.resize(delaunay.num_vertex_slots());
  vertex_flags_.resize(delaunay.num_vertex_slots(), 0);
  Examination x;
  // A sample that stops being interior may leave behind others that it took in: look at those too.
  for (std::vector<VertexId> left;; left.clear()) {
    x.patch = patches_.build(delaunay, core);
    x.find_normals(normals_, quiet);
    x.cocones = intersect_cocones(x.triangulation(), x.dual, x.poles, options_.cocone, quiet);
    x.states =
        judge_samples(x.triangulation(), x.dual, x.poles, x.cocones, options_.boundary, quiet);
    const auto flags = [&](VertexId v) { return vertex_flags_[x.patch.vertex_in_whole[v]]; };
    for (const VertexId v : x.triangulation().vertices()) {
      if (x.patch.is_core[v] != 0) continue;
      x.states[v] = (flags(v) & taken_in) != 0 ? SampleState::pending : SampleState::interior;
    }
    for (const CellId c : x.triangulation().finite_cells()) {
      const Cell& cell = x.triangulation().cell(c);
      const bool loses = std::any_of(cell.vertices.begin(), cell.vertices.end(), [&](VertexId v) {
        return x.patch.is_core[v] != 0 && x.states[v] != SampleState::interior &&
               (flags(v) & both_conditions) != 0;
      });
      if (!loses) continue;
      for (const VertexId v : cell.vertices) {
        if (x.patch.is_core[v] == 0 && (flags(v) & taken_in) != 0) {
          left.push_back(x.patch.vertex_in_whole[v]);
        }
      }
    }
    if (left.empty()) break;
    core.insert(core.end(), left.begin(), left.end());
    std::sort(core.begin(), core.end());
    core.erase(std::unique(core.begin(), core.end()), core.end());
  }
  x.taken = taken_in_at_once(x.triangulation(), x.poles, x.cocones, x.states, options_.boundary);
  if (!x.all_interior()) return false;

  x.dirty = VertexSet(x.triangulation().num_vertices(), 0);
  {
    VertexSet whole(delaunay.num_vertex_slots(), 0);
    for (const VertexId v : dirty) whole[v] = 1;
    for (const VertexId v : x.dirty.ids()) x.dirty[v] = whole[x.patch.vertex_in_whole[v]];
  }
  x.find_candidates(cell_flags_);
  std::optional<FacetSet> left = prune_patch(x.patch, x.candidates, pruned_, options_.prune, quiet);
  if (!left) return false;
  x.left = *std::move(left);
  x.take_outer_halves(outer_);
  std::vector<FacetId> open = x.halves();
  if (open.empty()) {
    const FacetId first = x.first_hull_candidate();
    if (first.is_none()) return false;
    x.set_outer(first);
    open.push_back(first);
  }
  if (!x.grow(std::move(open))) return false;
  if (!x.is_one_umbrella_everywhere(options_.good_vertices, quiet)) return false;
  num_vertices_ = delaunay.num_vertices();
  touched_.assign(dirty.begin(), dirty.end());
  commit(delaunay, x);
  return first_hull_candidate_is_outer(delaunay, x) && is_connected(delaunay, x);
}

void CertifiedSurface::commit(const DynamicDelaunay& delaunay, Examination& x) {
  const Triangulation& t = x.triangulation();
  const std::size_t slots = delaunay.view().cell_records().size();
  outer_.resize(slots, 0);
  cell_flags_.resize(slots, 0);
  pruned_.resize(slots, 0);
  const bool plain_centers = x.dual.extended_precision == 0 && x.dual.facet_fallbacks == 0;
  for (const CellId c : t.cells()) {
    unsigned flags = x.candidates.bits(c);
    flags |= t.is_infinite(c) ? infinite : finite;
    if (!plain_centers) flags |= center_flags(t, c);
    set_cell(x.patch.slot_of_cell[c], static_cast<std::uint8_t>(flags), x.outer[c],
             static_cast<std::uint8_t>(x.candidates.bits(c) & ~x.left.bits(c)));
  }
  VertexSet hull(t.num_vertices(), 0);
  for (const CellId c : t.infinite_cells()) {
    for (int i = 0; i < 3; ++i) hull[t.vertex(c, i)] = 1;
  }
  for (const VertexId v : t.vertices()) {
    if (x.patch.is_core[v] == 0) continue;
    const VertexId whole = x.patch.vertex_in_whole[v];
    normals_[whole] = x.poles.normals[v];
    const bool pending = x.states[v] == SampleState::pending;
    const unsigned state = pending ? taken_in : both_conditions;
    set_vertex(whole, static_cast<std::uint8_t>(state | (hull[v] != 0 ? on_hull : 0U)));
  }
  triangles_.clear();
  for (const FacetId f : x.halves()) {
    if (!x.has_dirty_vertex(f)) continue;
    const auto [a, b, c] = t.facet_vertices(f);  // normal away from the outer side
    triangles_.push_back(
        {x.patch.vertex_in_whole[a], x.patch.vertex_in_whole[c], x.patch.vertex_in_whole[b]});
  }
}

bool CertifiedSurface::first_hull_candidate_is_outer(const DynamicDelaunay& delaunay,
                                                     const Examination& x) {
  const TriangulationView view = delaunay.view();
  const auto is_hull_candidate = [&](CellId c) {
    return (cell_flags_[c] & (infinite | 8U)) == (infinite | 8U) && (pruned_[c] & 8U) == 0;
  };
  const FacetId here = x.first_hull_candidate();
  CellId first = here.is_none() ? CellId() : x.patch.slot_of_cell[cell_of(here)];
  const auto take_if_before = [&](CellId c) {
    if (first.is_none() ||
        sorted_corners(view, facet_id(c, 3)) < sorted_corners(view, facet_id(first, 3))) {
      first = c;
    }
  };
  const bool in_patch = first_hull_.is_none() || !is_hull_candidate(first_hull_) ||
                        std::find(x.patch.slot_of_cell.begin(), x.patch.slot_of_cell.end(),
                                  first_hull_) != x.patch.slot_of_cell.end();
  if (in_patch) {
    for (const CellId c : cell_flags_.ids()) {
      if (is_hull_candidate(c)) take_if_before(c);
    }
  } else {
    take_if_before(first_hull_);
  }
  first_hull_ = first;
  return !first.is_none() && (outer_[first] & 8U) != 0;
}

// The surface was connected before. What is left of it away from the dirty vertices falls into
// parts, each with a core vertex: it is connected now if the core is, by triangles of the patch;
// else all triangles are looked at.
bool CertifiedSurface::is_connected(const DynamicDelaunay& delaunay, const Examination& x) const {
  IdVector<VertexId, VertexId> parent;
  const auto root = [&](VertexId v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto make_parents = [&](std::size_t count) {
    parent.clear();
    for (const VertexId v : id_range<VertexId>(count)) parent.push_back(v);
  };
  const auto join = [&](const std::array<VertexId, 3>& v) {
    parent[root(v[1])] = root(v[0]);
    parent[root(v[2])] = root(v[0]);
  };
  make_parents(x.triangulation().num_vertices());
  for (const FacetId f : x.halves()) join(x.triangulation().facet_vertices(f));
  VertexSet counted(parent.size(), 0);
  std::size_t parts = 0;
  for (const VertexId v : parent.ids()) {
    if (x.patch.is_core[v] == 0 || counted[root(v)] != 0) continue;
    counted[root(v)] = 1;
    ++parts;
  }
  if (parts <= 1) return true;

  const TriangulationView view = delaunay.view();
  make_parents(delaunay.num_vertex_slots());
  for (const CellId c : outer_.ids()) {
    for (int i = 0; outer_[c] != 0 && i < 4; ++i) {
      if (((outer_[c] >> i) & 1) != 0) join(view.facet_vertices(facet_id(c, i)));
    }
  }
  parts = 0;
  for (const VertexId v : parent.ids()) parts += delaunay.contains(v) && parent[v] == v ? 1U : 0U;
  return parts == 1;
}

void CertifiedSurface::count(ReconstructCounters& counters) const {
  counters.hull_vertices = hull_vertices_;
  counters.dual_extended_precision = exact_centers_;
  counters.dual_facet_fallbacks = facet_centers_;
  counters.recovered_samples = taken_in_;
  counters.candidates = candidates_ / 2;
  counters.pruned = pruned_halves_ / 2;
  counters.umbrellas = num_vertices_;
  counters.surface_triangles = outer_halves_;
  counters.surface_walks = 1;
  counters.good_vertices = num_vertices_;
}

}  // namespace cocoon
