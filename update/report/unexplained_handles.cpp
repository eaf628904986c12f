#include "update/report/unexplained_handles.h"

#include <algorithm>
#include <vector>

#include "geom/equal_points.h"

namespace cocoon {

std::size_t unexplained_handles(std::span<const CloudReport> clouds, std::ptrdiff_t before,
                                std::ptrdiff_t after) {
  std::ptrdiff_t handles = (before - after) / 2;
  for (const CloudReport& cloud : clouds) {
    const auto loops = std::count_if(
        cloud.loops.begin(), cloud.loops.end(),
        [](const LoopReport& loop) { return loop.match == LoopMatch::on_model && !loop.pin_hole; });
    const std::ptrdiff_t torn = cloud.surface.rim.is_partial() ? 1 : 0;
    handles -= std::max<std::ptrdiff_t>(loops + torn - 1, 0);
  }
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(handles, 0));
}

std::size_t repeated_vertices(const ModelIndex& model) {
  if (model.has_distinct_points()) return 0;
  std::vector<Point> places;
  places.reserve(model.mesh().points.size());
  for (const VertexId v : model.mesh().points.ids()) {
    if (model.is_used(v)) places.push_back(model.mesh().points[v]);
  }
  return repeated_points(places).size();
}

}  // namespace cocoon
