#include "update/cloud/rim_seams.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geom/search/equal_points.h"
#include "geom/search/nearest_point.h"
#include "update/model/reached_cells.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Unit, orthogonal to edge i, away from the apex; the zero vector if the triangle has no area.
Vec3 outward(const RimLoop& loop, std::size_t i) {
  const Vec3 along = unit(loop.points[loop.next(i)] - loop.points[i]);
  const Vec3 apex = loop.apexes[i] - loop.points[i];
  return unit(dot(apex, along) * along - apex);
}

// The samples near the places beyond the edges of all loops: few of the cloud.
std::vector<Point> samples_near_edges(Points cloud, const CloudRim& rim,
                                      const RimSeamOptions& options) {
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
  const double reach = std::max(options.reach, options.few_reach);
  // A sample that is given twice counts once.
  return distinct_points(
      points_near(cloud, places, reach * std::max(rim.spacing, rim.median_edge)));
}

enum class Beyond { nothing, few, cloud };

Beyond what_is_beyond(const NearestPointTree& tree, Points samples, const RimLoop& loop,
                      std::size_t i, double spacing, const RimSeamOptions& options) {
  const Point place = place_beyond(loop, i, spacing);
  const auto is_end = [&](PointId p) {
    const Point& sample = samples[p.index()];
    return sample == loop.points[i] || sample == loop.points[loop.next(i)];
  };
  const NearestPoint nearest = tree.nearest(place);
  const double reach = options.reach * spacing;
  if (is_end(nearest.point) || nearest.squared_distance > reach * reach) return Beyond::nothing;
  std::size_t count = 0;
  const auto are_enough = [&](PointId p) {
    if (!is_end(p)) ++count;
    return count >= options.min_samples;
  };
  const bool is_cloud = tree.any_near(place, options.few_reach * spacing, are_enough);
  return is_cloud ? Beyond::cloud : Beyond::few;
}

bool has_mostly_seams(const RimLoop& loop, const RimSeamOptions& options) {
  return static_cast<double>(loop.inner_edges()) >
         options.max_seam_share * static_cast<double>(loop.size());
}

// The flags of the loop, with those marked, too, that lie between two marked ones and are fewer.
std::vector<std::uint8_t> without_short_runs(const RimLoop& loop, std::size_t shortest) {
  const std::size_t size = loop.size();
  std::vector<std::uint8_t> inner = loop.inner;
  const auto first = std::find(inner.begin(), inner.end(), 1);
  if (first == inner.end()) return inner;
  const auto start = static_cast<std::size_t>(first - inner.begin());
  std::size_t run = 0;
  for (std::size_t k = 1; k <= size; ++k) {  // ends at the edge where it begins
    if (loop.inner[(start + k) % size] == 0) {
      ++run;
      continue;
    }
    for (std::size_t back = 1; run < shortest && back <= run; ++back) {
      inner[(start + k - back) % size] = 1;
    }
    run = 0;
  }
  return inner;
}

// Finds the rim in a loop that is mostly seam. Returns whether there is one.
bool keep_rim_of_seam(RimLoop& loop, double median_edge, const RimSeamOptions& options) {
  if (options.min_rim_run == 0) return false;
  std::vector<std::uint8_t> inner = without_short_runs(loop, options.min_rim_run);
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (inner[i] == 0) length += distance(loop.points[i], loop.points[loop.next(i)]);
  }
  if (length < options.min_rim_length * median_edge || length == 0) return false;
  loop.inner = std::move(inner);
  return true;
}

}  // namespace

Point place_beyond(const RimLoop& loop, std::size_t i, double spacing) {
  return loop.middle(i) + spacing * outward(loop, i);
}

void mark_rim_seams(Points cloud, CloudRim& rim, const RimSeamOptions& options) {
  require_options("mark_rim_seams", options);
  const std::vector<Point> samples = samples_near_edges(cloud, rim, options);
  std::optional<NearestPointTree> tree;
  if (!samples.empty()) tree.emplace(samples);
  // Returns how many edges have a few samples beyond them.
  const auto mark = [&](RimLoop& loop, double spacing) {
    loop.inner.assign(loop.size(), 0);
    std::size_t few = 0;
    for (std::size_t i = 0; tree && i < loop.size(); ++i) {
      const Beyond beyond = what_is_beyond(*tree, samples, loop, i, spacing, options);
      loop.inner[i] = beyond == Beyond::cloud ? 1 : 0;
      few += beyond == Beyond::few ? 1U : 0U;
    }
    return few;
  };
  rim.lone_edges = 0;
  for (RimLoop& loop : rim.loops) rim.lone_edges += mark(loop, rim.spacing);
  for (RimLoop& loop : rim.pin_hole_loops) mark(loop, rim.median_edge);
  rim.rim_edges = 0;
  rim.seam_edges = 0;
  for (const RimLoop& loop : rim.loops) {
    rim.rim_edges += loop.size();
    rim.seam_edges += loop.inner_edges();
  }
  std::vector<RimLoop> rims;
  for (RimLoop& loop : rim.loops) {
    const bool is_mostly_seam = has_mostly_seams(loop, options);
    if (is_mostly_seam && !keep_rim_of_seam(loop, rim.median_edge, options)) {
      ++rim.seam_loops;
      continue;
    }
    rim.seamed_loops += is_mostly_seam ? 1U : 0U;
    rims.push_back(std::move(loop));
  }
  rim.loops = std::move(rims);
  std::erase_if(rim.pin_hole_loops,
                [&](const RimLoop& loop) { return has_mostly_seams(loop, options); });
}

}  // namespace cocoon
