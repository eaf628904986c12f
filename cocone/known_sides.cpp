#include "cocone/known_sides.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geom/sort_by_vertex.h"

namespace cocoon {
namespace {

using Corners = std::array<VertexId, 3>;

// From the smallest corner on: the same for all ways to write a triangle, but not turned over.
Corners canonical(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Triangles by their smallest corner.
class TriangleTable {
 public:
  TriangleTable(const Triangulation& triangulation, std::span<const KnownTriangle> triangles) {
    begins_ = sort_by_vertex(
        triangles.size(), triangulation.num_vertices(), {},
        [&](std::size_t count) { others_.resize(count); },
        [&](std::size_t begin, std::size_t end, const auto& put) {
          for (std::size_t t = begin; t < end; ++t) {
            Corners corners;
            std::transform(triangles[t].begin(), triangles[t].end(), corners.begin(),
                           [&](PointId p) { return triangulation.vertex_of_point()[p]; });
            const auto [a, b, c] = canonical(corners);
            put(a, [&, b = b, c = c](std::size_t place) { others_[place] = {b, c}; });
          }
        });
  }

  bool has(const Corners& corners) const {
    const auto [a, b, c] = canonical(corners);
    const std::array<VertexId, 2> wanted = {b, c};
    const auto first = others_.begin() + begins_[a.index()];
    const auto last = others_.begin() + begins_[a.index() + 1];
    return std::find(first, last, wanted) != last;
  }

 private:
  std::vector<std::uint32_t> begins_;
  std::vector<std::array<VertexId, 2>> others_;
};

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
  for (const KnownTriangle& t : triangles) {
    for (const PointId p : t) told.corners[triangulation.vertex_of_point()[p]] = 1;
  }
  const TriangleTable known(triangulation, triangles);
  const auto say = [&](FacetId behind) {
    if (!known.has(triangulation.facet_vertices(behind))) return;
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
