#include "update/model/updated_vertices.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geom/arrays/large_pages.h"

namespace cocoon {

IdVector<VertexId, VertexId> updated_vertices(const Replacement& replacement,
                                              const ReconstructResult& reconstruction) {
  // If each point is a vertex, they have the same order.
  const bool same = reconstruction.unused_points == 0;
  IdVector<PointId, VertexId> vertex_of_point(same ? 0 : replacement.points.size());
  if (!same) {
    for (const VertexId v : reconstruction.point_of_vertex.ids()) {
      vertex_of_point[reconstruction.point_of_vertex[v]] = v;
    }
  }
  const IdVector<VertexId, PointId>& points = replacement.point_of_vertex;
  IdVector<VertexId, VertexId> result;
  result.reserve(points.size());
  prefer_large_pages(result.raw());
  result.resize(points.size());
  static_assert(PointId().value == VertexId().value);  // none
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.raw()[i] = VertexId(points.raw()[i].value);
  }
  for (VertexId& v : result) {
    if (!same && !v.is_none()) v = vertex_of_point[PointId(v.value)];
  }
  return result;
}

VertexId first_vertex_of_clouds(const IdVector<VertexId, VertexId>& vertex_map) {
  std::uint32_t end = 0;
  for (const VertexId v : vertex_map) {
    if (!v.is_none()) end = std::max(end, v.value + 1);
  }
  return VertexId(end);
}

}  // namespace cocoon
