#include "cocone/surface_mesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "cocone/samples/shared_flags.h"
#include "geom/mesh/triangle_order.h"
#include "geom/messages/require_size.h"
#include "geom/parallel/parallel_list.h"

namespace cocoon {
namespace {

constexpr std::size_t elements_per_chunk = std::size_t{1} << 14;

// The first input point of each used vertex, increasing.
std::vector<PointId> used_points(const Triangulation& triangulation,
                                 std::span<const Triangle> triangles, const Execution& execution) {
  SharedFlags used(triangulation.num_vertices());
  parallel_chunks(execution, triangles.size(), elements_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      for (const VertexId v : triangles[t]) used.raise(v);
                    }
                  });
  const IdVector<PointId, VertexId>& vertex_of_point = triangulation.vertex_of_point();
  return parallel_list<PointId>(
      execution, vertex_of_point.size(), elements_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<PointId>& found) {
        for (PointId p(begin); p.index() < end; ++p) {
          const VertexId v = vertex_of_point[p];
          if (used.is_raised(v) && triangulation.point_of_vertex(v) == p) found.push_back(p);
        }
      });
}

// From triangles with the vertices of the triangulation, counterclockwise seen from outside.
SurfaceMesh mesh_of(const Triangulation& triangulation, std::span<const Triangle> triangles,
                    const Execution& execution) {
  SurfaceMesh surface;
  surface.point_of_vertex =
      IdVector<VertexId, PointId>(used_points(triangulation, triangles, execution));
  const std::size_t num_vertices = surface.point_of_vertex.size();
  surface.mesh.points.resize(num_vertices);
  surface.triangulation_vertex.resize(num_vertices);
  IdVector<VertexId, VertexId> number(triangulation.num_vertices());
  parallel_chunks(execution, num_vertices, elements_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (VertexId to(begin); to.index() < end; ++to) {
                      const PointId p = surface.point_of_vertex[to];
                      const VertexId v = triangulation.vertex_of_point()[p];
                      surface.mesh.points[to] = triangulation.point(v);
                      surface.triangulation_vertex[to] = v;
                      number[v] = to;
                    }
                  });
  surface.mesh.triangles = canonical_triangles(
      triangles.size(), num_vertices,
      [&](std::size_t t) {
        const auto& [a, b, c] = triangles[t];
        return Triangle{number[a], number[b], number[c]};
      },
      execution);
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

SurfaceMesh surface_of(const Triangulation& triangulation, std::span<const FacetId> halves,
                       const Execution& execution) {
  OverwriteVector<Triangle> triangles(halves.size());
  parallel_chunks(execution, halves.size(), elements_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      const auto [a, b, c] = triangulation.facet_vertices(halves[t]);
                      triangles[t] = {a, c, b};
                    }
                  });
  return mesh_of(triangulation, triangles, execution);
}

SurfaceMesh surface_of(const Triangulation& triangulation, LinkedFacets triangles,
                       std::span<const FacetId> halves, const Execution& execution) {
  require_size("surface_of", "halves of triangles", halves.size(), triangles.size());
  OverwriteVector<Triangle> corners = std::move(triangles.corners);
  parallel_chunks(execution, halves.size(), elements_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      // They are seen from behind the facet. Which half it is cannot be foreseen.
                      const auto [a, b, c] = corners[t];
                      const bool from_front = halves[t] == triangles.facets[t];
                      corners[t] = {a, from_front ? c : b, from_front ? b : c};
                    }
                  });
  triangles = {};
  return mesh_of(triangulation, corners, execution);
}

SurfaceMesh surface_between(const Triangulation& triangulation,
                            const IdVector<CellId, std::uint8_t>& reached,
                            const Execution& execution) {
  require_size("surface_between", "flags of reached cells", reached.size(),
               triangulation.num_cells());
  const std::vector<Triangle> triangles = parallel_list<Triangle>(
      execution, triangulation.num_finite_cells(), elements_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<Triangle>& found) {
        list_outer_facets(triangulation, reached, begin, end, found);
      });
  return mesh_of(triangulation, triangles, execution);
}

}  // namespace cocoon
