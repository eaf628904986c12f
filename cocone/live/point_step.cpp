#include "cocone/live/point_step.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "geom/arrays/points_of.h"
#include "geom/errors.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

// The vertex of a point that stays.
VertexId vertex_at(const DynamicDelaunay& delaunay,
                   const IdVector<PointId, VertexId>& vertex_of_point, PointId old_position,
                   const Point& point) {
  if (old_position.index() < vertex_of_point.size()) {
    const VertexId v = vertex_of_point[old_position];
    if (delaunay.point(v) == point) return v;
  }
  throw InputError("DynamicTightCocone: point " + std::to_string(old_position.value) +
                   " is said to stay, but is not among the points so far, or elsewhere; give the "
                   "position of an equal one, or none");
}

}  // namespace

void require_edit(const ListEdit<PointId>& change, std::size_t before, std::size_t after) {
  const auto is_in = [](const std::vector<PointId>& list, std::size_t size) {
    const auto fails = [](PointId p, PointId next) { return !(p < next); };
    return list.empty() || (list.back().index() < size &&
                            std::adjacent_find(list.begin(), list.end(), fails) == list.end());
  };
  if (is_in(change.removed, before) && is_in(change.added, after) &&
      change.size_after(before) == after) {
    return;
  }
  throw InputError("DynamicTightCocone: " + std::to_string(change.removed.size()) +
                   " points that go and " + std::to_string(change.added.size()) +
                   " that come do not lead from " + std::to_string(before) + " points to " +
                   std::to_string(after) + "; give the edit between these lists");
}

void require_positions(std::size_t points, std::span<const PointId> old_position,
                       std::size_t before) {
  require_size("DynamicTightCocone", "positions of points so far", old_position.size(), points);
  for (const PointId p : old_position) {
    if (!p.is_none()) require_index("DynamicTightCocone", "point so far", p.index(), before);
  }
}

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
      const VertexId v = vertex_at(delaunay, vertex_of_point, old_position[i], points[i]);
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
  step.inserted_points = points_of(points, change.added);
  step.vertex_of_point.resize(points.size());
  for (const KeptRun& run : kept_runs(change, vertex_of_point.size())) {
    std::copy_n(vertex_of_point.begin() + static_cast<std::ptrdiff_t>(run.from), run.count,
                step.vertex_of_point.begin() + static_cast<std::ptrdiff_t>(run.to));
  }
  return step;
}

}  // namespace cocoon
