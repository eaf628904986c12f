#include "cocone/kept/certified_surface.h"

#include <algorithm>
#include <utility>

#include "cocone/facets/facet_size.h"
#include "cocone/facets/good_parts.h"
#include "delaunay/circulate.h"
#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/sort_ids.h"

namespace cocoon {
namespace {

// Turns about the edge of f opposite `third`, from f's side, to the first candidate: the half of it
// that is met; none if there is no other.
FacetId first_met(const TriangulationView& view, const LiveCandidates& candidates, FacetId f,
                  VertexId third) {
  const FacetId back = view.mirror(f);
  for (;;) {
    const CellId c = cell_of(f);
    const int i = index_of_vertex(view.cell(c), third);
    const FacetId g = facet_id(c, i);
    if (g == back) return {};
    if (((candidates.left(c) >> i) & 1U) != 0) return g;
    third = view.vertex(c, index_of(f));
    f = view.mirror(g);
  }
}

}  // namespace

void CertifiedSurface::clear() {
  const Turn wrong = wrong_turn_;
  *this = CertifiedSurface(options_);
  wrong_turn_ = wrong;
}

bool CertifiedSurface::certify(const DynamicDelaunay& delaunay, const LiveCandidates& candidates,
                               const CoconeSurface& surface) {
  clear();
  const TriangulationView view = delaunay.view();
  if (is_still_refuted(view, candidates, surface.halves)) return false;
  begin_sheets(delaunay, surface);
  std::vector<VertexId> off_surface;
  for (const VertexId v : sheets_.ids()) {
    if (delaunay.contains(v) && !has(v)) off_surface.push_back(v);
  }
  off_surface_ = off_surface.size();
  if (num_vertices() != surface.umbrellas) {
    wrong_turn_ = find_open_turn(view, candidates, surface.halves);
    clear();
    return false;
  }
  exists_ = leaves_no_candidate(delaunay, candidates, off_surface);
  if (exists_) {
    sides_.resize(view.cell_records().size(), 0);
    for (const FacetId f : surface.halves) insert(view, f);
    wrong_turn_ = find_wrong_turn(view, candidates, surface.halves);
    exists_ = wrong_turn_.from.is_none();
  }
  if (!exists_) clear();
  return exists_;
}

// Whether the turn that was wrong is one of this surface, and wrong.
bool CertifiedSurface::is_still_refuted(const TriangulationView& view,
                                        const LiveCandidates& candidates,
                                        std::span<const FacetId> halves) const {
  const auto is_half = [&](FacetId f) {
    return std::find(halves.begin(), halves.end(), f) != halves.end();
  };
  const auto [from, third] = wrong_turn_;
  if (from.is_none() || !is_half(from)) return false;
  const Triangle corners = view.facet_vertices(from);
  if (std::find(corners.begin(), corners.end(), third) == corners.end()) return false;
  const FacetId met = first_met(view, candidates, from, third);
  return met.is_none() || !candidates.has_umbrella(third) || !is_half(met);
}

void CertifiedSurface::begin_sheets(const DynamicDelaunay& delaunay, const CoconeSurface& surface) {
  const TriangulationView view = delaunay.view();
  sheets_.resize(delaunay.num_vertex_slots(), SheetAt::none);
  for (const FacetId f : surface.halves) {
    for (const VertexId v : view.facet_vertices(f)) {
      sheets_[v] = surface.good[v] != 0 ? SheetAt::good : SheetAt::folded;
    }
  }
  count_sheets();
}

// One at a corner without an umbrella; none if there is none.
CertifiedSurface::Turn CertifiedSurface::find_open_turn(const TriangulationView& view,
                                                        const LiveCandidates& candidates,
                                                        std::span<const FacetId> halves) const {
  const auto is_open = [&](VertexId v) { return has(v) && !candidates.has_umbrella(v); };
  bool any = false;  // costs less to know than to look at all facets
  for (const VertexId v : sheets_.ids()) any = any || is_open(v);
  for (const FacetId f : any ? halves : std::span<const FacetId>()) {
    for (const VertexId v : view.facet_vertices(f)) {
      if (is_open(v)) return {f, v};
    }
  }
  return {};
}

// None if there is none.
CertifiedSurface::Turn CertifiedSurface::find_wrong_turn(const TriangulationView& view,
                                                         const LiveCandidates& candidates,
                                                         std::span<const FacetId> halves) const {
  for (const FacetId f : halves) {
    for (const VertexId v : view.facet_vertices(f)) {
      const FacetId met = first_met(view, candidates, f, v);
      if (met.is_none() || !is(side_flag::outer, met) || !candidates.has_umbrella(v)) return {f, v};
    }
  }
  return {};
}

void CertifiedSurface::resume(const DynamicDelaunay& delaunay, IdVector<CellId, std::uint8_t> sides,
                              IdVector<VertexId, SheetAt> sheets) {
  clear();
  sides_ = std::move(sides);
  sheets_ = std::move(sheets);
  for (const std::uint8_t s : sides_) outer_halves_ += num_flags(s & 15U);
  count_sheets();
  off_surface_ = delaunay.num_vertices() - num_vertices();
  exists_ = true;
}

bool CertifiedSurface::update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                              const LiveCandidates& candidates) {
  exists_ = false;
  new_good_ = 0;
  sides_.resize(delaunay.view().cell_records().size(), 0);
  sheets_.resize(delaunay.num_vertex_slots(), SheetAt::none);
  is_touched_.resize(delaunay.num_vertex_slots(), 0);
  forget(change);
  adopt_new_cells(delaunay.view(), change);
  touched_ = candidates.changed();
  for (const VertexId v : touched_) is_touched_[v] = 1;
  exists_ = update_at_touched(delaunay, change, candidates);
  for (const VertexId v : touched_) is_touched_[v] = 0;
  off_surface_ = delaunay.num_vertices() - num_vertices();
  if (!exists_) clear();
  return exists_;
}

bool CertifiedSurface::update_at_touched(const DynamicDelaunay& delaunay,
                                         const DelaunayChange& change,
                                         const LiveCandidates& candidates) {
  const TriangulationView view = delaunay.view();
  const auto& changed = candidates.facets_at_changed().triangles.facets;
  std::vector<FacetId> touched(changed.begin(), changed.end());
  std::erase_if(touched, [&](FacetId f) { return !has_touched_vertex(view, f); });
  erase_touched(view, candidates, touched);
  std::vector<VertexId> around = find_ring(view, candidates, touched);
  const std::vector<FacetId> halves = halves_at(delaunay, around);
  if (!grow(view, candidates, halves)) return false;

  std::vector<FacetId> facets;
  for (const FacetId f : touched) {
    if (is(side_flag::outer, f) || is(side_flag::inner, f)) facets.push_back(f);
  }
  for (const FacetId f : halves) facets.push_back(view.canonical(f));
  const LocalFacets surface = collector_.link(view, std::move(facets));
  around.insert(around.end(), touched_.begin(), touched_.end());
  if (!find_sheets(candidates, surface, around)) return false;
  list_triangles(view, surface);
  return candidates.num_boundary() < candidates.num_vertices() &&
         decides_cells(delaunay, change, around) &&
         leaves_no_candidate(delaunay, candidates, around) &&
         holds_first_hull_candidate(view, change, candidates, touched) &&
         is_connected(view, surface);
}

// --- The facets of S -------------------------------------------------------------------------

void CertifiedSurface::set_sides(CellId c, unsigned sides) {
  outer_halves_ -= num_flags(sides_[c] & 15U);
  sides_[c] = static_cast<std::uint8_t>(sides);
  outer_halves_ += num_flags(sides_[c] & 15U);
}

void CertifiedSurface::count_sheets() {
  for (const SheetAt sheet : sheets_) {
    good_ += sheet == SheetAt::good ? 1U : 0U;
    folded_ += sheet == SheetAt::folded ? 1U : 0U;
  }
}

void CertifiedSurface::set_sheet(VertexId v, SheetAt sheet) {
  good_ -= is_good(v) ? 1U : 0U;
  folded_ -= sheets_[v] == SheetAt::folded ? 1U : 0U;
  sheets_[v] = sheet;
  good_ += is_good(v) ? 1U : 0U;
  folded_ += sheet == SheetAt::folded ? 1U : 0U;
}

void CertifiedSurface::insert(const TriangulationView& view, FacetId half) {
  const FacetId back = view.mirror(half);
  set_sides(cell_of(half), sides_[cell_of(half)] | side_flag::outer << index_of(half));
  set_sides(cell_of(back), sides_[cell_of(back)] | side_flag::inner << index_of(back));
}

void CertifiedSurface::erase(const TriangulationView& view, FacetId f) {
  for (const FacetId half : {f, view.mirror(f)}) {
    const CellId c = cell_of(half);
    set_sides(c, sides_[c] & ~((side_flag::outer | side_flag::inner) << index_of(half)));
  }
}

bool CertifiedSurface::has_touched_vertex(const TriangulationView& view, FacetId f) const {
  const auto [a, b, c] = view.facet_vertices(f);
  return (is_touched_[a] | is_touched_[b] | is_touched_[c]) != 0;
}

// Slots of deleted cells may already hold new ones.
void CertifiedSurface::forget(const DelaunayChange& change) {
  for (const CellId c : change.deleted) {
    set_sides(c, 0);
    if (c == first_hull_) first_hull_ = CellId();
  }
  for (const VertexId v : change.removed) set_sheet(v, SheetAt::none);
}

// Facets that have got another cell on one side are what they were.
void CertifiedSurface::adopt_new_cells(const TriangulationView& view,
                                       const DelaunayChange& change) {
  for (const CellId c : change.created) {
    for (int i = 0; i < 4; ++i) {
      const FacetId behind = view.mirror(facet_id(c, i));
      if (is(side_flag::outer, behind)) set_sides(c, sides_[c] | side_flag::inner << i);
      if (is(side_flag::inner, behind)) set_sides(c, sides_[c] | side_flag::outer << i);
    }
  }
}

// What was a facet of S at a touched vertex is a candidate there, was one, or has gone.
void CertifiedSurface::erase_touched(const TriangulationView& view,
                                     const LiveCandidates& candidates,
                                     std::span<const FacetId> touched) {
  for (const FacetId f : touched) erase(view, f);
  for (const FacetId f : candidates.dropped()) erase(view, f);
}

// The other vertices of candidates at touched ones.
std::vector<VertexId> CertifiedSurface::find_ring(const TriangulationView& view,
                                                  const LiveCandidates& candidates,
                                                  std::span<const FacetId> touched) const {
  std::vector<VertexId> ring;
  for (const FacetId f : touched) {
    if (((candidates.left(cell_of(f)) >> index_of(f)) & 1U) == 0) continue;
    for (const VertexId v : view.facet_vertices(f)) {
      if (is_touched_[v] == 0) ring.push_back(v);
    }
  }
  make_set(ring);
  return ring;
}

std::vector<FacetId> CertifiedSurface::halves_at(const DynamicDelaunay& delaunay,
                                                 std::span<const VertexId> at) {
  const TriangulationView view = delaunay.view();
  std::vector<FacetId> halves;
  for (const CellId c : stars_.stars(delaunay, at)) {
    for (int i = 0; (sides_[c] & 15U) != 0 && i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (!is(side_flag::outer, f)) continue;
      const Triangle corners = view.facet_vertices(f);
      if (std::any_of(corners.begin(), corners.end(),
                      [&](VertexId v) { return std::binary_search(at.begin(), at.end(), v); })) {
        halves.push_back(f);
      }
    }
  }
  return halves;
}

// Turns about the edges of outer halves and adds what is met. False if it meets what cannot be.
bool CertifiedSurface::grow(const TriangulationView& view, const LiveCandidates& candidates,
                            std::vector<FacetId> open) {
  while (!open.empty()) {
    const FacetId f = open.back();
    open.pop_back();
    for (const VertexId v : view.facet_vertices(f)) {
      const FacetId met = first_met(view, candidates, f, v);
      if (met.is_none() || is(side_flag::inner, met)) return false;
      if (is(side_flag::outer, met)) continue;
      if (!has_touched_vertex(view, met)) return false;
      insert(view, met);
      open.push_back(met);
    }
  }
  return true;
}

// --- What holds ------------------------------------------------------------------------------

// What the surface is at these vertices; false if it is something that cannot be.
bool CertifiedSurface::find_sheets(const LiveCandidates& candidates, const LocalFacets& surface,
                                   std::span<const VertexId> vertices) {
  VertexSet boundary(surface.num_vertices(), 0);
  for (const VertexId local : boundary.ids()) {
    boundary[local] = candidates.is_boundary(surface.vertex_in_whole[local]) ? 1 : 0;
  }
  const GoodVertices found = good_vertices(surface.triangles, boundary, options_.good_vertices);
  for (const VertexId v : vertices) {
    const VertexId local = surface.local(v);
    SheetAt sheet = SheetAt::none;
    if (!local.is_none()) {
      const bool is_good = found.good[local] != 0;
      const bool is_folded = std::binary_search(found.folded.begin(), found.folded.end(), local);
      if ((!is_good && !is_folded) || !candidates.has_umbrella(v)) return false;
      sheet = is_good ? SheetAt::good : SheetAt::folded;
    }
    new_good_ += sheet == SheetAt::good && !is_good(v) ? 1U : 0U;
    set_sheet(v, sheet);
  }
  return true;
}

// Whether new cells, and those at vertices at hand that are not good, have a good vertex.
bool CertifiedSurface::decides_cells(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                                     std::span<const VertexId> vertices) {
  const TriangulationView view = delaunay.view();
  const auto is_decided = [&](CellId c) {
    const auto& [a, b, d, e] = view.cell(c).vertices;
    return e == infinite_vertex || is_good(a) || is_good(b) || is_good(d) || is_good(e);
  };
  std::vector<VertexId> not_good;
  for (const VertexId v : vertices) {
    if (!is_good(v)) not_good.push_back(v);
  }
  const std::span<const CellId> cells = stars_.stars(delaunay, not_good);
  return std::all_of(change.created.begin(), change.created.end(), is_decided) &&
         std::all_of(cells.begin(), cells.end(), is_decided);
}

// Whether each candidate at those of the vertices that are off the surface has a corner on it.
bool CertifiedSurface::leaves_no_candidate(const DynamicDelaunay& delaunay,
                                           const LiveCandidates& candidates,
                                           std::span<const VertexId> vertices) {
  const TriangulationView view = delaunay.view();
  std::vector<VertexId> off_surface;
  for (const VertexId v : vertices) {
    if (!has(v)) off_surface.push_back(v);
  }
  for (const CellId c : stars_.stars(delaunay, off_surface)) {
    const unsigned left = candidates.left(c);
    for (int i = 0; (left >> i) != 0; ++i) {
      if (((left >> i) & 1U) == 0) continue;
      const auto [a, b, d] = view.facet_vertices(facet_id(c, i));
      if (!has(a) && !has(b) && !has(d)) return false;
    }
  }
  return true;
}

std::vector<Triangle> CertifiedSurface::triangles(const TriangulationView& view) const {
  std::vector<Triangle> all;
  all.reserve(outer_halves_);
  for (const CellId c : sides_.ids()) {
    const unsigned inner = unsigned{sides_[c]} >> 4;
    for (int i = 0; inner != 0 && i < 4; ++i) {
      // facet_vertices: normal away from the cell, here the inner one
      if (((inner >> i) & 1U) != 0) all.push_back(view.facet_vertices(facet_id(c, i)));
    }
  }
  return all;
}

void CertifiedSurface::list_triangles(const TriangulationView& view, const LocalFacets& surface) {
  triangles_.clear();
  for (const FacetId f : surface.triangles.facets) {
    if (!has_touched_vertex(view, f)) continue;
    // facet_vertices: normal away from the cell, here the inner one
    triangles_.push_back(view.facet_vertices(is(side_flag::inner, f) ? f : view.mirror(f)));
  }
}

bool CertifiedSurface::holds_first_hull_candidate(const TriangulationView& view,
                                                  const DelaunayChange& change,
                                                  const LiveCandidates& candidates,
                                                  std::span<const FacetId> touched) {
  const auto is_hull_candidate = [&](CellId c) {
    if (!candidates.is_infinite(c) || (candidates.left(c) & 8U) == 0) return false;
    const auto [a, b, d] = view.facet_vertices(facet_id(c, 3));
    return candidates.has_umbrella(a) && candidates.has_umbrella(b) && candidates.has_umbrella(d);
  };
  FacetSize least = {};  // of first_hull_
  const auto consider = [&](CellId c) {
    if (!is_hull_candidate(c)) return;
    const FacetSize size = size_of_facet(view, facet_id(c, 3));
    if (!first_hull_.is_none() && !(size < least)) return;
    first_hull_ = c;
    least = size;
  };
  if (first_hull_.is_none() || !is_hull_candidate(first_hull_)) {
    first_hull_ = CellId();
    for (const CellId c : sides_.ids()) consider(c);
  } else {
    least = size_of_facet(view, facet_id(first_hull_, 3));
    for (const CellId c : change.created) consider(c);
    for (const FacetId f : touched) {
      consider(cell_of(f));
      consider(cell_of(view.mirror(f)));
    }
  }
  if (first_hull_.is_none() || !is(side_flag::outer, facet_id(first_hull_, 3))) return false;
  const auto [a, b, d] = view.facet_vertices(facet_id(first_hull_, 3));
  return is_good(a) || is_good(b) || is_good(d);
}

// Whether the good vertices hang together. They did before. A part of them without a corner of the
// facets at hand is as it was, with all its neighbors: it is all there was. So it is enough that
// the good vertices at hand hang together and one of them was good before, or that there are none.
// Else all triangles are looked at.
bool CertifiedSurface::is_connected(const TriangulationView& view,
                                    const LocalFacets& surface) const {
  DisjointSets local(surface.num_vertices());
  const auto is_good_here = [&](VertexId v) { return is_good(surface.vertex_in_whole[v]); };
  std::size_t good_here = 0;
  for (const VertexId v : surface.vertex_in_whole) good_here += is_good(v) ? 1U : 0U;
  std::size_t parts_here = good_here;
  for (const Triangle& t : surface.triangles.corners) {
    parts_here -= join_good(local, t, is_good_here);
  }
  if (parts_here == 0 || (parts_here == 1 && good_here > new_good_)) return true;
  DisjointSets whole(sheets_.size());
  std::size_t parts = good_;
  for (const CellId c : sides_.ids()) {
    for (int i = 0; (sides_[c] & 15U) != 0 && i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (!is(side_flag::outer, f)) continue;
      parts -= join_good(whole, view.facet_vertices(f), [&](VertexId v) { return is_good(v); });
    }
  }
  return parts == 1;
}

void CertifiedSurface::count(ReconstructCounters& counters) const {
  counters.surface_triangles = outer_halves_;
  counters.surface_walks = 1;
  counters.good_vertices = good_;
  counters.demoted_vertices = folded_;
  const bool cleaned_up = options_.clean_up.enabled && folded_ + off_surface_ > 0;
  counters.clean_up.unused_before = cleaned_up ? off_surface_ : 0;
  counters.clean_up.unused_after = counters.clean_up.unused_before;
}

}  // namespace cocoon
