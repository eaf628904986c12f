#include "cocone/known_sides.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace cocoon {
namespace {

using Corners = std::array<VertexId, 3>;

// From the smallest corner on: the same for all ways to write a triangle, but not turned over.
Corners canonical(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// What the triangles tell the cells beside them, and which vertices are their corners.
struct Told {
  enum : std::uint8_t { out = 1, in = 2 };
  IdVector<CellId, std::uint8_t> cells;
  VertexSet corners;
};

Told tell(const Triangulation& triangulation, const LinkedFacets& surface,
          std::span<const KnownTriangle> triangles) {
  Told told = {IdVector<CellId, std::uint8_t>(triangulation.num_cells(), 0),
               VertexSet(triangulation.num_vertices(), 0)};
  std::vector<Corners> known;
  for (const KnownTriangle& t : triangles) {
    Corners corners;
    std::transform(t.begin(), t.end(), corners.begin(),
                   [&](PointId p) { return triangulation.vertex_of_point()[p]; });
    for (const VertexId v : corners) told.corners[v] = 1;
    known.push_back(canonical(corners));
  }
  std::sort(known.begin(), known.end());
  const auto say = [&](FacetId behind) {
    const Corners corners = canonical(triangulation.facet_vertices(behind));
    if (!std::binary_search(known.begin(), known.end(), corners)) return;
    const CellId front = cell_of(triangulation.mirror(behind));
    told.cells[cell_of(behind)] |= Told::in;
    told.cells[front] |= Told::out;
  };
  for (const FacetId f : surface.facets) {
    say(f);
    say(triangulation.mirror(f));
  }
  return told;
}

}  // namespace

KnownSides known_sides(const Triangulation& triangulation, const LinkedFacets& surface,
                       std::span<const KnownTriangle> triangles) {
  const Told told = tell(triangulation, surface, triangles);
  KnownSides known;
  known.labels = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
  for (const CellId c : triangulation.finite_cells()) {
    if (told.cells[c] == (Told::out | Told::in)) ++known.contradictions;
    if (told.cells[c] != Told::out && told.cells[c] != Told::in) continue;
    const auto& vertices = triangulation.cell(c).vertices;
    if (!std::all_of(vertices.begin(), vertices.end(),
                     [&](VertexId v) { return told.corners[v] != 0; })) {
      continue;
    }
    known.labels[c] = told.cells[c] == Told::out ? CellLabel::out : CellLabel::in;
    ++known.cells;
  }
  return known;
}

}  // namespace cocoon
