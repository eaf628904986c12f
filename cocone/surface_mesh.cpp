#include "cocone/surface_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cocoon {
namespace {

// Numbers the used vertices by their first input points.
IdVector<VertexId, VertexId> number_vertices(const Triangulation& triangulation,
                                             const VertexSet& used, SurfaceMesh& surface) {
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  surface.mesh.points.reserve(count);
  surface.point_of_vertex.reserve(count);
  surface.triangulation_vertex.reserve(count);
  IdVector<VertexId, VertexId> number(triangulation.num_vertices());
  const IdVector<PointId, VertexId>& vertex_of_point = triangulation.vertex_of_point();
  for (const PointId p : vertex_of_point.ids()) {
    const VertexId v = vertex_of_point[p];
    if (used[v] == 0 || !number[v].is_none()) continue;
    number[v] = surface.mesh.points.push_back(triangulation.point(v));
    surface.point_of_vertex.push_back(p);
    surface.triangulation_vertex.push_back(v);
  }
  return number;
}

// From triangles with the vertices of the triangulation, counterclockwise seen from outside.
SurfaceMesh mesh_of(const Triangulation& triangulation, std::vector<Triangle> triangles) {
  VertexSet used(triangulation.num_vertices(), 0);
  for (const Triangle& triangle : triangles) {
    for (const VertexId v : triangle) used[v] = 1;
  }
  SurfaceMesh surface;
  const IdVector<VertexId, VertexId> number = number_vertices(triangulation, used, surface);
  for (Triangle& triangle : triangles) {
    for (VertexId& v : triangle) v = number[v];
  }
  surface.mesh.triangles = IdVector<TriangleId, Triangle>(std::move(triangles));
  canonicalize_triangles(surface.mesh);
  return surface;
}

// The facets of the cells begin .. end of the body that have the outside behind them, as seen from
// there. No branch depends on what is inside: half of the guesses would be wrong.
void list_outer_facets(const Triangulation& triangulation,
                       const IdVector<CellId, std::uint8_t>& reached, std::size_t begin,
                       std::size_t end, std::vector<Triangle>& triangles) {
  constexpr std::size_t cells_per_block = 256;
  std::array<CellId, cells_per_block> cells;
  std::array<FacetId, 4 * cells_per_block + 1> facets;
  for (std::size_t first = begin; first < end; first += cells_per_block) {
    std::size_t num_cells = 0;
    for (CellId c(first); c.index() < std::min(first + cells_per_block, end); ++c) {
      cells[num_cells] = c;
      num_cells += reached[c] == 0 ? 1U : 0U;
    }
    std::size_t num_facets = 0;
    for (std::size_t k = 0; k < num_cells; ++k) {
      const Cell& cell = triangulation.cell(cells[k]);
      for (unsigned i = 0; i < 4; ++i) {
        facets[num_facets] = facet_id(cells[k], static_cast<int>(i));
        num_facets += reached[cell_of(cell.neighbors[i])] != 0 ? 1U : 0U;
      }
    }
    for (std::size_t k = 0; k < num_facets; ++k) {
      triangles.push_back(triangulation.facet_vertices(facets[k]));
    }
  }
}

}  // namespace

SurfaceMesh surface_of(const Triangulation& triangulation, std::span<const FacetId> halves) {
  std::vector<Triangle> triangles;
  triangles.reserve(halves.size());
  for (const FacetId f : halves) {
    const auto [a, b, c] = triangulation.facet_vertices(f);
    triangles.push_back({a, c, b});
  }
  return mesh_of(triangulation, std::move(triangles));
}

SurfaceMesh surface_between(const Triangulation& triangulation, const CellMarks& marks) {
  std::vector<Triangle> triangles;
  list_outer_facets(triangulation, marks.reached, 0, triangulation.num_finite_cells(), triangles);
  return mesh_of(triangulation, std::move(triangles));
}

}  // namespace cocoon
