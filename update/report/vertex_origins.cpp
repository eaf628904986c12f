#include "update/report/vertex_origins.h"

namespace cocoon {

IdVector<VertexId, VertexOrigin> vertex_origins(const UpdateResult& result) {
  const Replacement& replacement = result.replacement;
  constexpr VertexOrigin unknown{Id<VertexTag>::none_value, 0};
  IdVector<PointId, VertexOrigin> of_point(replacement.points.size(), unknown);
  const auto note = [&](PointId point, std::uint32_t input, std::uint32_t index) {
    if (!point.is_none() && of_point[point] == unknown) of_point[point] = {input, index};
  };
  for (const VertexId v : replacement.point_of_vertex.ids()) {
    note(replacement.point_of_vertex[v], 0, v.value);
  }
  for (std::size_t c = 0; c < replacement.point_of_cloud_point.size(); ++c) {
    const IdVector<PointId, PointId>& points = replacement.point_of_cloud_point[c];
    for (const PointId p : points.ids()) {
      note(points[p], static_cast<std::uint32_t>(c + 1), p.value);
    }
  }
  IdVector<VertexId, VertexOrigin> origins(result.reconstruction.point_of_vertex.size());
  for (const VertexId v : origins.ids()) {
    origins[v] = of_point[result.reconstruction.point_of_vertex[v]];
  }
  return origins;
}

}  // namespace cocoon
