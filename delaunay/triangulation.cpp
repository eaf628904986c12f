#include "delaunay/triangulation.h"

namespace cocoon {

Triangulation::Triangulation(TriangulationArrays arrays, std::size_t finite_cells)
    : arrays_(std::move(arrays)),
      finite_cells_(finite_cells),
      point_of_vertex_(arrays_.points.size()) {
  for (const PointId p : arrays_.vertex_of_point.ids()) {
    PointId& first = point_of_vertex_[arrays_.vertex_of_point[p]];
    if (first.is_none()) first = p;
  }
}

}  // namespace cocoon
