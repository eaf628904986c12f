#include "cocone/live/point_step.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace cocoon {

PointStep plan_step(const DynamicDelaunay& delaunay,
                    const IdVector<PointId, VertexId>& vertex_of_point, Points points,
                    std::span<const PointId> old_position) {
  PointStep step;
  step.vertex_of_point.resize(points.size());
  std::vector<std::uint8_t> stays(delaunay.num_vertex_slots(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (old_position[i].is_none()) {
      step.inserted.push_back(PointId(i));
      step.inserted_points.push_back(points[i]);
    } else {
      const VertexId v = vertex_of_point[old_position[i]];
      step.vertex_of_point[PointId(i)] = v;
      stays[v.index()] = 1;
    }
  }
  for (const VertexId v : vertex_of_point) {
    if (stays[v.index()] != 0) continue;
    stays[v.index()] = 1;  // listed once
    step.removed.push_back(v);
    step.removed_points.push_back(delaunay.point(v));
  }
  return step;
}

PointStep plan_step(const DynamicDelaunay& delaunay,
                    const IdVector<PointId, VertexId>& vertex_of_point, Points points,
                    const ListEdit<PointId>& change) {
  PointStep step;
  for (const PointId p : change.removed) {
    step.removed.push_back(vertex_of_point[p]);
    step.removed_points.push_back(delaunay.point(vertex_of_point[p]));
  }
  step.inserted = change.added;
  for (const PointId p : change.added) step.inserted_points.push_back(points[p.index()]);
  step.vertex_of_point.resize(points.size());
  for (const KeptRun& run : kept_runs(change, vertex_of_point.size())) {
    std::copy_n(vertex_of_point.begin() + static_cast<std::ptrdiff_t>(run.from), run.count,
                step.vertex_of_point.begin() + static_cast<std::ptrdiff_t>(run.to));
  }
  return step;
}

}  // namespace cocoon
