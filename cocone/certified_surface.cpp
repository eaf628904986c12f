#include "cocone/certified_surface.h"

#include <algorithm>
#include <utility>

#include "cocone/cell_order.h"
#include "delaunay/circulate.h"
#include "geom/disjoint_sets.h"
#include "geom/sort_ids.h"

namespace cocoon {
namespace {

// Every vertex an interior sample with an umbrella.
bool is_regular_everywhere(const LiveCandidates& candidates) {
  return candidates.num_boundary() == 0 && candidates.num_umbrellas() == candidates.num_vertices();
}

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

// Joins the vertices of a triangle; returns how many parts there are fewer for that.
std::size_t join_corners(DisjointSets& parts, const std::array<VertexId, 3>& v) {
  return (parts.join(v[0].value, v[1].value) ? 1U : 0U) +
         (parts.join(v[0].value, v[2].value) ? 1U : 0U);
}

}  // namespace

void CertifiedSurface::clear() { *this = CertifiedSurface(options_); }

bool CertifiedSurface::certify(const DynamicDelaunay& delaunay, const LiveCandidates& candidates,
                               std::span<const FacetId> halves) {
  clear();
  if (!is_regular_everywhere(candidates)) return false;
  const TriangulationView view = delaunay.view();
  sides_.resize(view.cell_records().size(), 0);
  for (const FacetId f : halves) insert(view, f);
  for (const FacetId f : halves) {
    for (const VertexId v : view.facet_vertices(f)) {
      const FacetId met = first_met(view, candidates, f, v);
      if (!met.is_none() && is(side_flag::outer, met)) continue;
      clear();
      return false;
    }
  }
  num_vertices_ = delaunay.num_vertices();
  exists_ = true;
  return true;
}

void CertifiedSurface::resume(const DynamicDelaunay& delaunay,
                              IdVector<CellId, std::uint8_t> sides) {
  clear();
  sides_ = std::move(sides);
  for (const std::uint8_t s : sides_) {
    outer_halves_ += num_flags(s & 15U);
  }
  num_vertices_ = delaunay.num_vertices();
  exists_ = true;
}

bool CertifiedSurface::update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                              const LiveCandidates& candidates) {
  exists_ = false;
  if (!is_regular_everywhere(candidates)) {
    clear();
    return false;
  }
  sides_.resize(delaunay.view().cell_records().size(), 0);
  is_touched_.resize(delaunay.num_vertex_slots(), 0);
  forget(change);
  adopt_new_cells(delaunay.view(), change);
  touched_ = candidates.changed();
  for (const VertexId v : touched_) is_touched_[v] = 1;
  exists_ = update_at_touched(delaunay, change, candidates);
  for (const VertexId v : touched_) is_touched_[v] = 0;
  num_vertices_ = delaunay.num_vertices();
  if (!exists_) clear();
  return exists_;
}

bool CertifiedSurface::update_at_touched(const DynamicDelaunay& delaunay,
                                         const DelaunayChange& change,
                                         const LiveCandidates& candidates) {
  const TriangulationView view = delaunay.view();
  std::vector<FacetId> touched = candidates.facets_at_changed().triangles.facets;
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
  const LocalFacets surface = collector_.link(delaunay, std::move(facets));
  around.insert(around.end(), touched_.begin(), touched_.end());
  if (!holds_at(surface, around)) return false;
  list_triangles(view, surface);
  return holds_first_hull_candidate(view, change, candidates, touched) &&
         is_connected(delaunay, surface);
}

// --- The facets of S -------------------------------------------------------------------------

void CertifiedSurface::set_sides(CellId c, unsigned sides) {
  outer_halves_ -= num_flags(sides_[c] & 15U);
  sides_[c] = static_cast<std::uint8_t>(sides);
  outer_halves_ += num_flags(sides_[c] & 15U);
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
      const std::array<VertexId, 3> corners = view.facet_vertices(f);
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

// One umbrella, not folded, at each of these vertices.
bool CertifiedSurface::holds_at(const LocalFacets& surface,
                                std::span<const VertexId> vertices) const {
  const VertexSet no_boundary(surface.num_vertices(), 0);
  const GoodVertices good = good_vertices(surface.triangles, no_boundary, options_);
  return std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) {
    const VertexId local = surface.local(v);
    return !local.is_none() && good.good[local] != 0;
  });
}

std::vector<std::array<VertexId, 3>> CertifiedSurface::triangles(
    const TriangulationView& view) const {
  std::vector<std::array<VertexId, 3>> all;
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
    return candidates.is_infinite(c) && (candidates.left(c) & 8U) != 0;
  };
  const auto consider = [&](CellId c) {
    if (!is_hull_candidate(c)) return;
    if (first_hull_.is_none() ||
        sorted_corners(view, facet_id(c, 3)) < sorted_corners(view, facet_id(first_hull_, 3))) {
      first_hull_ = c;
    }
  };
  if (first_hull_.is_none() || !is_hull_candidate(first_hull_)) {
    first_hull_ = CellId();
    for (const CellId c : sides_.ids()) consider(c);
  } else {
    for (const CellId c : change.created) consider(c);
    for (const FacetId f : touched) {
      consider(cell_of(f));
      consider(cell_of(view.mirror(f)));
    }
  }
  return !first_hull_.is_none() && is(side_flag::outer, facet_id(first_hull_, 3));
}

// The surface was connected before, and what is left of it falls into parts that each reach one of
// the places looked at: it is connected now if these hang together; else all triangles are looked
// at.
bool CertifiedSurface::is_connected(const DynamicDelaunay& delaunay,
                                    const LocalFacets& surface) const {
  DisjointSets local(surface.num_vertices());
  std::size_t parts = surface.num_vertices();
  for (const Triangle& t : surface.triangles.corners) parts -= join_corners(local, t);
  if (parts <= 1) return true;

  const TriangulationView view = delaunay.view();
  DisjointSets whole(delaunay.num_vertex_slots());
  parts = delaunay.num_vertices();
  for (const CellId c : sides_.ids()) {
    for (int i = 0; (sides_[c] & 15U) != 0 && i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (is(side_flag::outer, f)) parts -= join_corners(whole, view.facet_vertices(f));
    }
  }
  return parts == 1;
}

void CertifiedSurface::count(ReconstructCounters& counters) const {
  counters.surface_triangles = outer_halves_;
  counters.surface_walks = 1;
  counters.good_vertices = num_vertices_;
}

}  // namespace cocoon
