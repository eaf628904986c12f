#include "update/updated_vertices.h"

#include <cstddef>

#include "geom/large_pages.h"

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
  for (const VertexId v : points.ids()) {
    const PointId p = points[v];
    static_assert(PointId().value == VertexId().value);  // none
    result[v] = same || p.is_none() ? VertexId(p.value) : vertex_of_point[p];
  }
  return result;
}

}  // namespace cocoon
