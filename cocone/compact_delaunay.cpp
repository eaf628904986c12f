#include "cocone/compact_delaunay.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace cocoon {
namespace {

// What is known by slot, by number.
template <class IdType, class T>
IdVector<IdType, T> by_number(const IdVector<IdType, T>& by_slot,
                              const IdVector<IdType, IdType>& number, std::size_t count) {
  IdVector<IdType, T> values(count);
  for (const IdType slot : number.ids()) {
    if (!number[slot].is_none()) values[number[slot]] = by_slot[slot];
  }
  return values;
}

}  // namespace

CompactDelaunay compact_delaunay(const DynamicDelaunay& delaunay,
                                 const IdVector<PointId, VertexId>& vertex_of_point) {
  const TriangulationView view = delaunay.view();
  TriangulationArrays arrays;
  IdVector<VertexId, VertexId> number(delaunay.num_vertex_slots());
  for (const VertexId v : number.ids()) {
    if (delaunay.contains(v)) number[v] = arrays.points.push_back(view.point(v));
  }
  IdVector<CellId, CellId> place(view.cell_records().size());
  std::size_t count = 0;
  for (const CellId c : place.ids()) {
    if (view.is_finite_cell(c)) place[c] = CellId(count++);
  }
  const std::size_t finite_cells = count;
  for (const CellId c : place.ids()) {
    if (!view.is_free(c) && view.is_infinite(c)) place[c] = CellId(count++);
  }
  arrays.cells.resize(count);
  for (const CellId c : place.ids()) {
    if (place[c].is_none()) continue;
    Cell cell = view.cell(c);
    for (VertexId& v : cell.vertices) v = v == infinite_vertex ? v : number[v];
    for (FacetId& f : cell.neighbors) f = facet_id(place[cell_of(f)], index_of(f));
    arrays.cells[place[c]] = cell;
  }
  arrays.vertex_of_point.reserve(vertex_of_point.size());
  for (const VertexId v : vertex_of_point) arrays.vertex_of_point.push_back(number[v]);
  return {Triangulation(std::move(arrays), finite_cells), std::move(number), std::move(place)};
}

KnownCandidates known_candidates(const LiveCandidates& candidates, const CompactDelaunay& whole) {
  KnownCandidates found;
  const std::size_t count = whole.triangulation.num_vertices();
  found.normals.resize(count);
  found.boundary.resize(count, 0);
  found.umbrella.resize(count, 0);
  for (const VertexId v : whole.vertex.ids()) {
    const VertexId here = whole.vertex[v];
    if (here.is_none()) continue;
    found.normals[here] = candidates.normal(v);
    found.boundary[here] = candidates.is_boundary(v) ? 1 : 0;
    found.umbrella[here] = candidates.has_umbrella(v) ? 1 : 0;
  }
  IdVector<CellId, std::uint8_t> left(whole.triangulation.num_cells(), 0);
  for (const CellId c : whole.cell.ids()) {
    if (whole.cell[c].is_none()) continue;
    left[whole.cell[c]] = static_cast<std::uint8_t>(candidates.left(c));
  }
  found.left = FacetSet(std::move(left));
  candidates.count(found.counters);
  return found;
}

SurfaceState surface_state(const LiveCandidates& candidates, const CertifiedSurface& certified,
                           const CompactDelaunay& whole) {
  SurfaceState state;
  if (!candidates.exists()) return state;
  const CandidateState& known = candidates.state();
  const std::size_t vertices = whole.triangulation.num_vertices();
  const std::size_t cells = whole.triangulation.num_cells();
  CandidateState& here = state.candidates;
  here.normals = by_number(known.normals, whole.vertex, vertices);
  here.vertex_flags = by_number(known.vertex_flags, whole.vertex, vertices);
  here.samples = by_number(known.samples, whole.vertex, vertices);
  here.steps = by_number(known.steps, whole.vertex, vertices);
  here.cell_flags = by_number(known.cell_flags, whole.cell, cells);
  here.pruned = by_number(known.pruned, whole.cell, cells);
  if (!certified.exists()) return state;
  state.sides = by_number(certified.sides(), whole.cell, cells);
  state.sheets = by_number(certified.sheets(), whole.vertex, vertices);
  return state;
}

}  // namespace cocoon
