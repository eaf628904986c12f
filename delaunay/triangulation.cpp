#include "delaunay/triangulation.h"

namespace cocoon {

namespace {

constexpr std::size_t grain = std::size_t{1} << 15;

}  // namespace

Triangulation::Triangulation(TriangulationArrays arrays, std::size_t finite_cells,
                             const Execution& execution)
    : arrays_(std::move(arrays)),
      finite_cells_(finite_cells),
      point_of_vertex_(arrays_.points.size()) {
  const IdVector<PointId, VertexId>& vertex_of_point = arrays_.vertex_of_point;
  if (num_duplicates() == 0) {
    parallel_chunks(execution, vertex_of_point.size(), grain,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t p = begin; p < end; ++p) {
                        point_of_vertex_[vertex_of_point[PointId(p)]] = PointId(p);
                      }
                    });
    return;
  }
  for (const PointId p : vertex_of_point.ids()) {
    PointId& first = point_of_vertex_[vertex_of_point[p]];
    if (first.is_none()) first = p;
  }
}

}  // namespace cocoon
