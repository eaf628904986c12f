#include "update/cloud/torn_edges.h"

#include <cmath>
#include <utility>
#include <vector>

#include "update/cloud/rim_seams.h"
#include "update/model/reached_cells.h"
#include "update/model/sample_heights.h"

namespace cocoon {

namespace {

struct RimEdge {
  std::size_t loop;
  std::size_t index;
  Point middle;
  Vec3 outward;  // unit
};

std::vector<RimEdge> edges_to_ask(const CloudRim& rim) {
  std::vector<RimEdge> edges;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    const RimLoop& loop = rim.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop.is_inner(i)) continue;
      const Point middle = 0.5 * (loop.points[i] + loop.points[loop.next(i)]);
      edges.push_back({l, i, middle, unit(place_beyond(loop, i, rim.spacing) - middle)});
    }
  }
  return edges;
}

// How many edges of each loop are torn.
std::vector<std::size_t> count_torn(const ModelIndex& model,
                                    std::span<const std::vector<Point>> clouds, const CloudRim& rim,
                                    const TornEdgeOptions& options) {
  std::vector<std::size_t> torn(rim.loops.size(), 0);
  const std::vector<RimEdge> edges = edges_to_ask(rim);
  std::vector<Point> middles;
  middles.reserve(edges.size());
  for (const RimEdge& edge : edges) middles.push_back(edge.middle);
  if (middles.empty()) return torn;
  const double reach = options.reach * rim.spacing;
  std::vector<Point> samples;
  for (const std::vector<Point>& cloud : clouds) {
    const std::vector<Point> near = points_near(cloud, middles, reach);
    samples.insert(samples.end(), near.begin(), near.end());
  }
  if (samples.empty()) return torn;

  const double bound = 2 * reach;
  std::vector<Point> places = middles;
  places.insert(places.end(), samples.begin(), samples.end());
  const std::vector<double> heights = squared_heights(model, places, bound);
  const auto of_samples = heights.begin() + static_cast<std::ptrdiff_t>(middles.size());
  const SampleHeights around(std::move(samples), {of_samples, heights.end()});
  const double outward = options.min_outward * rim.spacing;
  const double least_step = options.min_step * rim.spacing;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RimEdge& edge = edges[k];
    const double height = std::sqrt(heights[k]);
    torn[edge.loop] += around.any_near(edge.middle, reach, [&](const Point& p, double squared) {
      return std::abs(std::sqrt(squared) - height) > least_step &&
             dot(p - edge.middle, edge.outward) >= outward;
    });
  }
  return torn;
}

bool is_torn_all_along(const RimLoop& loop, std::size_t torn, const TornEdgeOptions& options) {
  const std::size_t inner = loop.inner_edges();
  const auto size = static_cast<double>(loop.size());
  const auto others = static_cast<double>(loop.size() - inner);
  return static_cast<double>(torn) > options.min_torn_share * others &&
         static_cast<double>(torn + inner) > options.max_seam_share * size;
}

}  // namespace

void mark_torn_edges(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                     CloudRim& rim, const TornEdgeOptions& options) {
  const std::vector<std::size_t> torn = count_torn(model, clouds, rim, options);
  std::vector<std::size_t> seams;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (is_torn_all_along(rim.loops[l], torn[l], options)) seams.push_back(l);
  }
  if (seams.size() == rim.loops.size()) return;
  for (const std::size_t l : seams) {
    rim.loops[l].is_seam = true;
    rim.loops[l].inner.assign(rim.loops[l].size(), 1);
    rim.torn_edges += torn[l];
    rim.seam_edges += torn[l];
  }
}

}  // namespace cocoon
