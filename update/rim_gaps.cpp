#include "update/rim_gaps.h"

#include <algorithm>
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

std::size_t gap_edges(const RimLoop& loop) {
  return static_cast<std::size_t>(std::count(loop.gap.begin(), loop.gap.end(), 1));
}

}  // namespace

void mark_rim_gaps(const NearestPointTree& samples, Points cloud, CloudRim& rim,
                   const RimGapOptions& options) {
  const auto mark = [&](RimLoop& loop, double spacing) {
    loop.gap.assign(loop.size(), 0);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (has_cloud_beyond(samples, cloud, loop, i, spacing, options.reach)) loop.gap[i] = 1;
    }
  };
  for (RimLoop& loop : rim.loops) mark(loop, rim.spacing);
  for (RimLoop& loop : rim.pin_hole_loops) mark(loop, rim.median_edge);
  rim.rim_edges = 0;
  rim.gap_edges = 0;
  for (const RimLoop& loop : rim.loops) {
    rim.rim_edges += loop.size();
    rim.gap_edges += gap_edges(loop);
  }
  const auto is_gap = [&](const RimLoop& loop) {
    const auto edges = static_cast<double>(loop.size());
    return static_cast<double>(gap_edges(loop)) > options.max_gap_share * edges;
  };
  rim.gap_loops += std::erase_if(rim.loops, is_gap);
  std::erase_if(rim.pin_hole_loops, is_gap);
}

}  // namespace cocoon
