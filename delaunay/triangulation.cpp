#include "delaunay/triangulation.h"

namespace cocoon {

Triangulation::Triangulation(IdVector<VertexId, Point> points, IdVector<CellId, Cell> cells,
                             std::size_t finite_cells, IdVector<PointId, VertexId> vertex_of_point)
    : points_(std::move(points)),
      cells_(std::move(cells)),
      finite_cells_(finite_cells),
      vertex_of_point_(std::move(vertex_of_point)),
      point_of_vertex_(points_.size()) {
  for (const PointId p : vertex_of_point_.ids()) {
    PointId& first = point_of_vertex_[vertex_of_point_[p]];
    if (first.is_none()) first = p;
  }
}

std::array<VertexId, 3> Triangulation::facet_vertices(FacetId f) const {
  const Cell& cell = cells_[cell_of(f)];
  const int* corner = facet_corners[index_of(f)];
  return {cell.vertices[static_cast<std::size_t>(corner[0])],
          cell.vertices[static_cast<std::size_t>(corner[1])],
          cell.vertices[static_cast<std::size_t>(corner[2])]};
}

}  // namespace cocoon
