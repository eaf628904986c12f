#include "cocone/live/live_candidates.h"

#include <algorithm>
#include <utility>

#include "cocone/candidate_triangles.h"
#include "cocone/cocones.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/umbrella.h"
#include "delaunay/voronoi_dual.h"
#include "geom/arrays/large_pages.h"
#include "geom/arrays/sort_ids.h"
#include "geom/circumsphere.h"
#include "geom/triangle_normal.h"

namespace cocoon {
namespace {

// Finite or not.
unsigned kind_of(const TriangulationView& view, CellId c) {
  return view.is_infinite(c) ? cell_flag::infinite : cell_flag::finite;
}

// How the Voronoi vertex, or ray, of a cell is obtained, as voronoi_dual counts it.
unsigned center_kind(const TriangulationView& view, CellId c) {
  const auto& [v0, v1, v2, v3] = view.cell(c).vertices;
  const Point& p0 = view.point(v0);
  const Point& p1 = view.point(v1);
  const Point& p2 = view.point(v2);
  if (v3 == infinite_vertex) {
    return triangle_normal(p0, p1, p2).exact ? cell_flag::exact_center : 0;
  }
  switch (circumcenter(p0, p1, p2, view.point(v3)).level) {
    case CenterLevel::doubles:
      return 0;
    case CenterLevel::exact:
      return cell_flag::exact_center;
    case CenterLevel::facet:
    case CenterLevel::centroid:
      return cell_flag::facet_center;
  }
  return 0;
}

}  // namespace

void LiveCandidates::clear() { *this = LiveCandidates(options_); }

void LiveCandidates::start(const DynamicDelaunay& delaunay, const ReconstructStages& stages) {
  clear();
  fit_arrays(delaunay);
  const TriangulationView view = delaunay.view();
  start_samples(view, stages);
  for (const CellId c : known_.cell_flags.ids()) {
    const unsigned candidates = stages.candidates.bits(c);
    known_.cell_flags[c] = static_cast<std::uint8_t>(kind_of(view, c) | candidates);
    known_.pruned[c] = static_cast<std::uint8_t>(candidates & ~unsigned{stages.left.bits(c)});
  }
  for (const CellId c : stages.not_in_doubles) {
    known_.cell_flags[c] = static_cast<std::uint8_t>(known_.cell_flags[c] | center_kind(view, c));
  }
  begin(delaunay);
}

void LiveCandidates::resume(const DynamicDelaunay& delaunay, CandidateState state) {
  clear();
  known_ = std::move(state);
  fit_arrays(delaunay);
  begin(delaunay);
}

void LiveCandidates::start_samples(const TriangulationView& view, const ReconstructStages& stages) {
  known_.normals.reserve(stages.poles.normals.size());
  prefer_large_pages(known_.normals.raw());
  known_.normals = stages.poles.normals;
  known_.samples = stages.boundary.states;
  for (const VertexId v : known_.samples.ids()) {
    if (known_.samples[v] != SampleState::interior) known_.steps[v] = not_taken_in;
  }
  for (const TakenIn& taken : stages.boundary.taken_in) known_.steps[taken.sample] = taken.steps;
  for (const VertexId v : known_.vertex_flags.ids()) {
    unsigned flags = 0;
    if (stages.poles.degenerate[v] != 0) flags |= vertex_flag::degenerate;
    if (stages.umbrella[v] != 0) flags |= vertex_flag::umbrella;
    known_.vertex_flags[v] = static_cast<std::uint8_t>(flags);
  }
  for (const CellId c : known_.cell_flags.ids()) {
    if (!view.is_infinite(c)) continue;
    for (int i = 0; i < 3; ++i) known_.vertex_flags[view.vertex(c, i)] |= vertex_flag::on_hull;
  }
}

// With all slots in use.
void LiveCandidates::begin(const DynamicDelaunay& delaunay) {
  const TriangulationView view = delaunay.view();
  num_vertices_ = delaunay.num_vertices();
  for (const VertexId v : known_.vertex_flags.ids()) counts_.add(known_, v);
  for (const CellId c : known_.cell_flags.ids()) {
    counts_.add(known_, c);
    const unsigned candidates = known_.cell_flags[c] & cell_flag::candidate_facets;
    for (int i = 0; candidates != 0 && i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (((candidates >> i) & 1U) == 0 || view.canonical(f) != f) continue;
      for (const VertexId v : view.facet_vertices(f)) ++fan_[v];
    }
  }
  exists_ = true;
}

void LiveCandidates::update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                            const Execution& execution) {
  forget(change);
  fit_arrays(delaunay);
  changed_.assign(change.inserted.begin(), change.inserted.end());
  dirty_.clear();
  const TriangulationView view = delaunay.view();
  for (const CellId c : change.created) {
    for (const VertexId v : view.cell(c).vertices) {
      if (v == infinite_vertex || is_dirty_[v] != 0) continue;
      is_dirty_[v] = 1;
      dirty_.push_back(v);
    }
  }
  for (const VertexId v : dirty_) is_dirty_[v] = 0;
  sort_ids(dirty_);
  examine(delaunay, execution);
}

void LiveCandidates::fit_arrays(const DynamicDelaunay& delaunay) {
  const std::size_t vertices = delaunay.num_vertex_slots();
  known_.normals.resize(vertices);
  known_.vertex_flags.resize(vertices, 0);
  known_.samples.resize(vertices, SampleState::interior);
  known_.steps.resize(vertices, 0);
  fan_.resize(vertices, 0);
  is_dirty_.resize(vertices, 0);
  const std::size_t cells = delaunay.view().cell_records().size();
  known_.cell_flags.resize(cells, 0);
  known_.pruned.resize(cells, 0);
}

// What went takes its counts along. Slots of deleted cells may already hold new ones.
void LiveCandidates::forget(const DelaunayChange& change) {
  for (const CellId c : change.deleted) set_cell(c, 0, 0);
  for (const VertexId v : change.removed) {
    set_vertex(v, 0, SampleState::interior, 0);
    fan_[v] = 0;
  }
}

void LiveCandidates::examine(const DynamicDelaunay& delaunay, const Execution& execution) {
  const Execution quiet{execution.threads, nullptr};
  num_vertices_ = delaunay.num_vertices();
  Part part = judge_part(delaunay, quiet);
  commit_samples(part);
  commit_new_cells(part);
  dropped_.clear();
  update_candidates(part, quiet);
  sort_changed();
  collect_facets(delaunay, changed_);
  update_umbrellas();
  update_pruning(delaunay);
}

void LiveCandidates::sort_changed() { make_set(changed_); }

// --- Samples ---------------------------------------------------------------------------------

// The dirty vertices, and as many others as it takes until what is known of the rest still holds.
LiveCandidates::Part LiveCandidates::judge_part(const DynamicDelaunay& delaunay,
                                                const Execution& execution) {
  Part part;
  std::vector<VertexId> core = dirty_;
  const auto build_with = [&](const std::vector<VertexId>& more) {
    core.insert(core.end(), more.begin(), more.end());
    make_set(core);
    part.patch = patches_.build(delaunay, core);
  };
  build_with({});
  if (const std::vector<VertexId> more = pending_off_core(part.patch); !more.empty()) {
    build_with(more);
  }
  for (;;) {
    find_normals(part, execution);
    std::vector<VertexId> more = judge(part, execution);
    if (more.empty()) more = take_in(part);
    if (more.empty()) return part;
    build_with(more);
  }
}

// Whoever failed the normal condition may meet it now.
std::vector<VertexId> LiveCandidates::pending_off_core(const LocalPatch& patch) const {
  std::vector<VertexId> found;
  for (const VertexId v : patch.triangulation.vertices()) {
    const VertexId whole = patch.vertex_in_whole[v];
    if (patch.is_core[v] == 0 && known_.samples[whole] == SampleState::pending)
      found.push_back(whole);
  }
  return found;
}

void LiveCandidates::find_normals(Part& part, const Execution& execution) const {
  const Triangulation& t = part.patch.triangulation;
  part.dual = voronoi_dual(t, execution);
  part.poles = compute_poles(t, part.dual, execution);
  for (const VertexId v : t.vertices()) {
    if (part.patch.is_core[v] != 0) continue;
    part.poles.normals[v] = known_.normals[part.patch.vertex_in_whole[v]];
  }
  part.cocones = intersect_cocones(t, part.dual, part.poles, options_.cocone, execution);
}

bool LiveCandidates::Part::has(const VertexSet& set, FacetId f) const {
  for (const VertexId v : patch.triangulation.facet_vertices(f)) {
    if (v != infinite_vertex && set[v] != 0) return true;
  }
  return false;
}

// Both conditions. Returns samples off the core that met both and fail one now.
std::vector<VertexId> LiveCandidates::judge(Part& part, const Execution& execution) const {
  const LocalPatch& patch = part.patch;
  part.states = judge_samples(patch.triangulation, part.dual, part.poles, part.cocones,
                              options_.boundary, execution);
  for (const VertexId v : part.states.ids()) {
    if (patch.is_core[v] == 0) part.states[v] = known_.samples[patch.vertex_in_whole[v]];
  }
  std::vector<VertexId> failing;
  for (std::size_t k = 0; k < part.cocones.facets.size(); ++k) {
    if (!part.has(patch.is_core, part.cocones.facets[k])) continue;
    for_each_cocone_neighbor(part.cocones, k, [&](VertexId p, VertexId q, std::size_t) {
      if (patch.is_core[p] != 0 || part.states[p] != SampleState::interior) return;
      if (normals_agree(part.poles, p, q, options_.boundary)) return;
      failing.push_back(patch.vertex_in_whole[p]);
    });
  }
  return failing;
}

// Phase 2 in the core. Returns samples off the core whose supporters have changed.
std::vector<VertexId> LiveCandidates::take_in(Part& part) const {
  const LocalPatch& patch = part.patch;
  struct Support {
    VertexId sample;
    VertexId by;
  };
  std::vector<Support> supports;
  for (std::size_t k = 0; k < part.cocones.facets.size(); ++k) {
    if (!part.has(patch.is_core, part.cocones.facets[k])) continue;
    for_each_cocone_neighbor(part.cocones, k, [&](VertexId p, VertexId q, std::size_t) {
      if (part.states[p] != SampleState::pending) return;
      if (part.states[q] == SampleState::ratio_fails) return;
      if (normals_agree(part.poles, p, q, options_.boundary)) supports.push_back({p, q});
    });
  }
  part.steps = IdVector<VertexId, std::uint32_t>(part.states.size(), not_taken_in);
  for (const VertexId v : part.steps.ids()) {
    if (patch.is_core[v] == 0) {
      part.steps[v] = known_.steps[patch.vertex_in_whole[v]];
    } else if (part.states[v] == SampleState::interior) {
      part.steps[v] = 0;
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const Support& s : supports) {
      if (patch.is_core[s.sample] == 0 || part.steps[s.by] == not_taken_in) continue;
      if (part.steps[s.by] + 1 >= part.steps[s.sample]) continue;
      part.steps[s.sample] = part.steps[s.by] + 1;
      changed = true;
    }
  }
  std::vector<VertexId> affected;
  for (const Support& s : supports) {
    if (patch.is_core[s.sample] != 0 || patch.is_core[s.by] == 0) continue;
    if (part.steps[s.by] == known_.steps[patch.vertex_in_whole[s.by]]) continue;
    affected.push_back(patch.vertex_in_whole[s.sample]);
  }
  return affected;
}

void LiveCandidates::commit_samples(Part& part) {
  const LocalPatch& patch = part.patch;
  const Triangulation& t = patch.triangulation;
  part.fresh = VertexSet(t.num_vertices(), 0);
  for (const VertexId v : dirty_) is_dirty_[v] = 1;
  VertexSet hull(t.num_vertices(), 0);
  for (const CellId c : t.infinite_cells()) {
    for (int i = 0; i < 3; ++i) hull[t.vertex(c, i)] = 1;
  }
  for (const VertexId v : t.vertices()) {
    if (patch.is_core[v] == 0) continue;
    const VertexId whole = patch.vertex_in_whole[v];
    const bool relabeled = (part.steps[v] == not_taken_in) != is_boundary(whole);
    part.fresh[v] = relabeled || is_dirty_[whole] != 0;
    if (relabeled) note_changed(whole);
    known_.normals[whole] = part.poles.normals[v];
    unsigned flags = known_.vertex_flags[whole] & vertex_flag::umbrella;
    if (hull[v] != 0) flags |= vertex_flag::on_hull;
    if (part.poles.degenerate[v] != 0) flags |= vertex_flag::degenerate;
    set_vertex(whole, flags, part.states[v], part.steps[v]);
  }
  for (const VertexId v : dirty_) is_dirty_[v] = 0;
}

// --- Candidates ------------------------------------------------------------------------------

void LiveCandidates::commit_new_cells(const Part& part) {
  const Triangulation& t = part.patch.triangulation;
  for (const CellId c : t.cells()) {
    const CellId slot = part.patch.slot_of_cell[c];
    if (known_.cell_flags[slot] != 0) continue;
    set_cell(slot, kind_of(t, c), 0);
  }
  for (const CellId c : part.dual.not_in_doubles) {
    const CellId slot = part.patch.slot_of_cell[c];
    set_cell(slot, known_.cell_flags[slot] | center_kind(t, c), known_.pruned[slot]);
  }
}

void LiveCandidates::update_candidates(const Part& part, const Execution& execution) {
  const LocalPatch& patch = part.patch;
  const Triangulation& t = patch.triangulation;
  VertexSet boundary(t.num_vertices(), 0);
  for (const VertexId v : boundary.ids()) boundary[v] = part.steps[v] == not_taken_in ? 1 : 0;
  const FacetSet candidates = candidate_triangles(t, part.cocones, boundary, execution);

  IdVector<VertexId, std::uint32_t> fan(t.num_vertices(), 0);     // now
  IdVector<VertexId, std::uint32_t> growth(t.num_vertices(), 0);  // modulo 2^32
  VertexSet touched(t.num_vertices(), 0);
  // Facets that were candidates or are, each from one of the cells that say so.
  const auto before_or_now = [&](CellId c) {
    return (known_.cell_flags[patch.slot_of_cell[c]] & cell_flag::candidate_facets) |
           unsigned{candidates.bits(c)};
  };
  for (const CellId c : t.cells()) {
    const unsigned told = before_or_now(c);
    for (int i = 0; told >> i != 0; ++i) {
      const unsigned bit = 1U << i;
      const FacetId f = facet_id(c, i);
      if ((told & bit) == 0 || !t.is_finite_facet(f) || !part.has(part.fresh, f)) continue;
      const FacetId m = t.mirror(f);
      const unsigned mirror_bit = 1U << index_of(m);
      if (m < f && (before_or_now(cell_of(m)) & mirror_bit) != 0) continue;  // was looked at
      const CellId here = patch.slot_of_cell[c];
      const CellId there = patch.slot_of_cell[cell_of(m)];
      const bool before =
          (known_.cell_flags[here] & bit) != 0 || (known_.cell_flags[there] & mirror_bit) != 0;
      const bool now = candidates.contains(f);
      const bool pruned =
          now && ((known_.pruned[here] & bit) != 0 || (known_.pruned[there] & mirror_bit) != 0);
      const auto write = [&](CellId slot, unsigned which) {
        set_cell(slot, now ? known_.cell_flags[slot] | which : known_.cell_flags[slot] & ~which,
                 pruned ? known_.pruned[slot] | which : known_.pruned[slot] & ~which);
      };
      write(here, bit);
      write(there, mirror_bit);
      if (!now) dropped_.push_back(facet_id(here, i));
      for (const VertexId v : t.facet_vertices(f)) {
        fan[v] += now ? 1U : 0U;
        if (before == now) continue;
        growth[v] += now ? 1U : static_cast<std::uint32_t>(-1);
        touched[v] = 1;
      }
    }
  }
  // At a vertex of new cells candidates may also have gone together with both of their cells.
  for (const VertexId v : t.vertices()) {
    const VertexId whole = patch.vertex_in_whole[v];
    if (part.fresh[v] != 0) {
      if (fan[v] != fan_[whole] + growth[v]) touched[v] = 1;
      fan_[whole] = fan[v];
    } else {
      fan_[whole] += growth[v];
    }
    if (touched[v] != 0) note_changed(whole);
  }
}

// --- Umbrellas and pruning -------------------------------------------------------------------

void LiveCandidates::collect_facets(const DynamicDelaunay& delaunay,
                                    std::span<const VertexId> vertices) {
  facets_ = collector_.collect(delaunay, vertices, [&](CellId c) {
    return known_.cell_flags[c] & cell_flag::candidate_facets;
  });
}

void LiveCandidates::update_umbrellas() {
  const VertexSet found = vertices_with_umbrella(facets_.triangles, facets_.num_vertices(),
                                                 options_.prune.sharp_cosine);
  for (const VertexId v : changed_) {
    const VertexId local = facets_.local(v);
    unsigned flags = known_.vertex_flags[v] & ~vertex_flag::umbrella;
    if (!local.is_none() && found[local] != 0) flags |= vertex_flag::umbrella;
    set_vertex(v, flags, known_.samples[v], known_.steps[v]);
  }
}

void LiveCandidates::update_pruning(const DynamicDelaunay& delaunay) {
  std::vector<VertexId> core = changed_;
  for (;;) {
    const LinkedFacets& triangles = facets_.triangles;
    VertexSet in_core(facets_.num_vertices(), 0);
    VertexSet guards(facets_.num_vertices(), 0);
    for (const VertexId v : in_core.ids()) {
      const VertexId whole = facets_.vertex_in_whole[v];
      in_core[v] = std::binary_search(core.begin(), core.end(), whole) ? 1 : 0;
      guards[v] = has_umbrella(whole) ? 1 : 0;
    }
    const std::vector<std::uint8_t> removed =
        prune_part(triangles, in_core, guards, options_.prune);
    std::vector<VertexId> more;
    for (std::uint32_t t = 0; t < removed.size(); ++t) {
      if (removed[t] == was_pruned(triangles.facets[t])) continue;
      int corners = 0;
      for (const VertexId v : triangles.corners[t]) corners += in_core[v];
      if (corners != 1) continue;  // no edge off the core
      for (const VertexId v : triangles.corners[t]) more.push_back(facets_.vertex_in_whole[v]);
    }
    if (more.empty()) {
      commit_pruning(removed);
      break;
    }
    core.insert(core.end(), more.begin(), more.end());
    make_set(core);
    collect_facets(delaunay, core);
  }
  sort_changed();
  if (!std::includes(core.begin(), core.end(), changed_.begin(), changed_.end())) {
    collect_facets(delaunay, changed_);
  }
}

std::uint8_t LiveCandidates::was_pruned(FacetId f) const {
  return static_cast<std::uint8_t>((known_.pruned[cell_of(f)] >> index_of(f)) & 1U);
}

void LiveCandidates::commit_pruning(const std::vector<std::uint8_t>& removed) {
  const LinkedFacets& triangles = facets_.triangles;
  for (std::uint32_t t = 0; t < removed.size(); ++t) {
    if (removed[t] == was_pruned(triangles.facets[t])) continue;
    for (const FacetId f : {triangles.facets[t], triangles.mirrors[t]}) {
      const CellId c = cell_of(f);
      set_cell(c, known_.cell_flags[c], known_.pruned[c] ^ (1U << index_of(f)));
    }
    for (const VertexId v : triangles.corners[t]) note_changed(facets_.vertex_in_whole[v]);
  }
}

// --- What is known ---------------------------------------------------------------------------

void LiveCandidates::renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay) {
  for (const auto& [a, b] : renumbering.cells) {
    std::swap(known_.cell_flags[a], known_.cell_flags[b]);
    std::swap(known_.pruned[a], known_.pruned[b]);
  }
  for (const auto& [from, to] : renumbering.vertices) {
    known_.normals[to] = known_.normals[from];
    known_.vertex_flags[to] = known_.vertex_flags[from];
    known_.samples[to] = known_.samples[from];
    known_.steps[to] = known_.steps[from];
    fan_[to] = fan_[from];
  }
  fit_arrays(delaunay);
  changed_.clear();
  facets_ = {};
  dropped_.clear();
}

void LiveCandidates::set_cell(CellId c, unsigned flags, unsigned pruned) {
  counts_.subtract(known_, c);
  known_.cell_flags[c] = static_cast<std::uint8_t>(flags);
  known_.pruned[c] = static_cast<std::uint8_t>(pruned);
  counts_.add(known_, c);
}

void LiveCandidates::set_vertex(VertexId v, unsigned flags, SampleState state,
                                std::uint32_t steps) {
  counts_.subtract(known_, v);
  known_.vertex_flags[v] = static_cast<std::uint8_t>(flags);
  known_.samples[v] = state;
  known_.steps[v] = steps;
  counts_.add(known_, v);
}

}  // namespace cocoon
