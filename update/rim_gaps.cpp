#include "update/rim_gaps.h"

#include <utility>
#include <vector>

namespace cocoon {

namespace {

// Unit, orthogonal to edge i, away from the apex; the zero vector if the triangle has no area.
Vec3 outward(const RimLoop& loop, std::size_t i) {
  const Vec3 along = unit(loop.points[loop.next(i)] - loop.points[i]);
  const Vec3 apex = loop.apexes[i] - loop.points[i];
  return unit(dot(apex, along) * along - apex);
}

bool has_cloud_beyond(const NearestPointTree& samples, Points cloud, const RimLoop& loop,
                      std::size_t i, double spacing, double reach) {
  const Point& from = loop.points[i];
  const Point& to = loop.points[loop.next(i)];
  const Point beyond = 0.5 * (from + to) + spacing * outward(loop, i);
  const NearestPoint nearest = samples.nearest(beyond);
  const Point& sample = cloud[nearest.point.index()];
  if (sample == from || sample == to) return false;
  return nearest.squared_distance <= reach * reach * spacing * spacing;
}

}  // namespace

void mark_rim_gaps(const NearestPointTree& samples, Points cloud, CloudRim& rim,
                   const RimGapOptions& options) {
  std::vector<RimLoop> kept;
  rim.rim_edges = 0;
  rim.gap_edges = 0;
  for (RimLoop& loop : rim.loops) {
    loop.gap.assign(loop.size(), 0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!has_cloud_beyond(samples, cloud, loop, i, rim.spacing, options.reach)) continue;
      loop.gap[i] = 1;
      ++count;
    }
    rim.rim_edges += loop.size();
    rim.gap_edges += count;
    if (static_cast<double>(count) > options.max_gap_share * static_cast<double>(loop.size())) {
      ++rim.gap_loops;
    } else {
      kept.push_back(std::move(loop));
    }
  }
  rim.loops = std::move(kept);
}

}  // namespace cocoon
