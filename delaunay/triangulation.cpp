#include "delaunay/triangulation.h"

#include <string>

#include "geom/errors.h"

namespace cocoon {

namespace {

constexpr std::size_t grain = std::size_t{1} << 15;

[[noreturn]] void throw_missing_vertex(PointId p, VertexId v, std::size_t vertices) {
  throw InputError("input point " + std::to_string(p.value) + " names vertex " +
                   std::to_string(v.value) + " of a triangulation with " +
                   std::to_string(vertices) + " vertices; repair its arrays");
}

}  // namespace

Triangulation::Triangulation(TriangulationArrays arrays, std::size_t finite_cells,
                             const Execution& execution)
    : arrays_(std::move(arrays)),
      finite_cells_(finite_cells),
      point_of_vertex_(arrays_.points.size()) {
  const IdVector<PointId, VertexId>& vertex_of_point = arrays_.vertex_of_point;
  const auto point_at_vertex_of = [&](PointId p) -> PointId& {
    const VertexId v = vertex_of_point[p];
    if (v.index() >= point_of_vertex_.size()) throw_missing_vertex(p, v, point_of_vertex_.size());
    return point_of_vertex_[v];
  };
  if (num_duplicates() == 0) {
    parallel_chunks(execution, vertex_of_point.size(), grain,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t p = begin; p < end; ++p) {
                        point_at_vertex_of(PointId(p)) = PointId(p);
                      }
                    });
    return;
  }
  for (const PointId p : vertex_of_point.ids()) {
    PointId& first = point_at_vertex_of(p);
    if (first.is_none()) first = p;
  }
}

}  // namespace cocoon
