#include "update/rim_gaps.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "geom/nearest_point.h"
#include "update/reached_cells.h"

namespace cocoon {

namespace {

// Unit, orthogonal to edge i, away from the apex; the zero vector if the triangle has no area.
Vec3 outward(const RimLoop& loop, std::size_t i) {
  const Vec3 along = unit(loop.points[loop.next(i)] - loop.points[i]);
  const Vec3 apex = loop.apexes[i] - loop.points[i];
  return unit(dot(apex, along) * along - apex);
}

// Where cloud beyond edge i would lie.
Point place_beyond(const RimLoop& loop, std::size_t i, double spacing) {
  return 0.5 * (loop.points[i] + loop.points[loop.next(i)]) + spacing * outward(loop, i);
}

// The samples near the places beyond the edges of all loops: few of the cloud.
std::vector<Point> samples_beyond(Points cloud, const CloudRim& rim, double reach) {
  std::vector<Point> places;
  const auto list = [&](const std::vector<RimLoop>& loops, double spacing) {
    for (const RimLoop& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        places.push_back(place_beyond(loop, i, spacing));
      }
    }
  };
  list(rim.loops, rim.spacing);
  list(rim.pin_hole_loops, rim.median_edge);
  if (places.empty()) return {};
  const double farthest = reach * std::max(rim.spacing, rim.median_edge);
  const ReachedCells near(places, reach_with_rounding(places, farthest));
  std::vector<Point> samples;
  for (const Point& p : cloud) {
    if (near.overlap(Box{p, p})) samples.push_back(p);
  }
  return samples;
}

bool has_cloud_beyond(const NearestPointTree& tree, Points samples, const RimLoop& loop,
                      std::size_t i, double spacing, double reach) {
  const NearestPoint nearest = tree.nearest(place_beyond(loop, i, spacing));
  const Point& sample = samples[nearest.point.index()];
  if (sample == loop.points[i] || sample == loop.points[loop.next(i)]) return false;
  return nearest.squared_distance <= reach * reach * spacing * spacing;
}

std::size_t gap_edges(const RimLoop& loop) {
  return static_cast<std::size_t>(std::count(loop.gap.begin(), loop.gap.end(), 1));
}

}  // namespace

void mark_rim_gaps(Points cloud, CloudRim& rim, const RimGapOptions& options) {
  const std::vector<Point> samples = samples_beyond(cloud, rim, options.reach);
  std::optional<NearestPointTree> tree;
  if (!samples.empty()) tree.emplace(samples);
  const auto mark = [&](RimLoop& loop, double spacing) {
    loop.gap.assign(loop.size(), 0);
    for (std::size_t i = 0; tree && i < loop.size(); ++i) {
      if (has_cloud_beyond(*tree, samples, loop, i, spacing, options.reach)) loop.gap[i] = 1;
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
