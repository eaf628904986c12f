#include "update/cloud/torn_edges.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "geom/search/box_tree.h"
#include "update/cloud/rim_seams.h"
#include "update/model/reached_cells.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

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

// A sample beyond an edge: one that could show that it is torn.
struct SampleBeyond {
  std::size_t edge;
  std::uint32_t sample;
};

// Few, where a rim is the end of its scan. `samples`: those near the edges.
std::vector<SampleBeyond> samples_beyond(const std::vector<RimEdge>& edges,
                                         const std::vector<Point>& samples, double reach,
                                         double outward) {
  std::vector<SampleBeyond> beyond;
  if (samples.empty()) return beyond;
  const BoxTree tree = tree_of_points(samples);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RimEdge& edge = edges[k];
    tree.visit_near(edge.middle, reach * reach, [&](std::uint32_t slot) {
      const std::uint32_t sample = tree.items()[slot];
      const Vec3 arm = samples[sample] - edge.middle;
      if (squared_norm(arm) <= reach * reach && dot(arm, edge.outward) >= outward) {
        beyond.push_back({k, sample});
      }
      return reach * reach;
    });
  }
  return beyond;
}

// The distances from the model of the places that are asked for, 0 for the others; infinity beyond
// the bound.
std::vector<double> heights_of(const ModelIndex& model, const std::vector<Point>& places,
                               const std::vector<std::uint8_t>& asked, double bound) {
  std::vector<Point> few;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (asked[k] != 0) few.push_back(places[k]);
  }
  const std::vector<double> squared = squared_heights(model, few, bound);
  std::vector<double> heights(places.size(), 0);
  std::size_t next = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (asked[k] != 0) heights[k] = std::sqrt(squared[next++]);
  }
  return heights;
}

// Places: the middles of the edges, then the samples. Most heights are of no interest, and they
// are what takes time.
std::vector<double> heights_of_pairs(const ModelIndex& model, const std::vector<RimEdge>& edges,
                                     const std::vector<Point>& samples,
                                     const std::vector<SampleBeyond>& beyond, double bound) {
  std::vector<Point> places;
  places.reserve(edges.size() + samples.size());
  for (const RimEdge& edge : edges) places.push_back(edge.middle);
  places.insert(places.end(), samples.begin(), samples.end());
  std::vector<std::uint8_t> asked(places.size(), 0);
  for (const SampleBeyond& pair : beyond) asked[pair.edge] = asked[edges.size() + pair.sample] = 1;
  return heights_of(model, places, asked, bound);
}

// Samples of all clouds within reach of an edge, and some more.
std::vector<Point> samples_near(std::span<const std::vector<Point>> clouds,
                                const std::vector<RimEdge>& edges, double reach) {
  std::vector<Point> middles;
  middles.reserve(edges.size());
  for (const RimEdge& edge : edges) middles.push_back(edge.middle);
  std::vector<Point> samples;
  if (middles.empty()) return samples;
  for (const std::vector<Point>& cloud : clouds) {
    const std::vector<Point> near = points_near(cloud, middles, reach);
    samples.insert(samples.end(), near.begin(), near.end());
  }
  return samples;
}

bool is_torn_all_along(const RimLoop& loop, std::size_t torn, const TornEdgeOptions& options) {
  const std::size_t inner = loop.inner_edges();
  const auto size = static_cast<double>(loop.size());
  const auto others = static_cast<double>(loop.size() - inner);
  return static_cast<double>(torn) > options.min_torn_share * others &&
         static_cast<double>(torn + inner) > options.max_seam_share * size;
}

// Leaves out the edges of loops that are no seams even if all of their edges with a sample beyond
// them are torn: that is most loops, and saves the heights there.
void leave_out_rims(const CloudRim& rim, const std::vector<RimEdge>& edges,
                    const TornEdgeOptions& options, std::vector<SampleBeyond>& beyond) {
  std::vector<std::size_t> most(rim.loops.size(), 0);
  for (std::size_t k = 0; k < beyond.size(); ++k) {  // in the order of edges
    if (k == 0 || beyond[k - 1].edge != beyond[k].edge) ++most[edges[beyond[k].edge].loop];
  }
  std::vector<std::uint8_t> may_be_seam(rim.loops.size());
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    may_be_seam[l] = is_torn_all_along(rim.loops[l], most[l], options) ? 1 : 0;
  }
  std::erase_if(beyond,
                [&](const SampleBeyond& pair) { return may_be_seam[edges[pair.edge].loop] == 0; });
}

// How many edges of each loop are torn, as far as it can be a seam.
std::vector<std::size_t> count_torn(const ModelIndex& model,
                                    std::span<const std::vector<Point>> clouds, const CloudRim& rim,
                                    const TornEdgeOptions& options) {
  const double reach = options.reach * rim.spacing;
  const std::vector<RimEdge> edges = edges_to_ask(rim);
  const std::vector<Point> samples = samples_near(clouds, edges, reach);
  std::vector<SampleBeyond> beyond =
      samples_beyond(edges, samples, reach, options.min_outward * rim.spacing);
  leave_out_rims(rim, edges, options, beyond);
  std::vector<std::size_t> torn(rim.loops.size(), 0);
  if (beyond.empty()) return torn;
  const std::vector<double> heights = heights_of_pairs(model, edges, samples, beyond, 2 * reach);
  std::vector<std::uint8_t> is_torn(edges.size(), 0);
  for (const SampleBeyond& pair : beyond) {
    const double step = heights[edges.size() + pair.sample] - heights[pair.edge];
    if (std::abs(step) > options.min_step * rim.spacing) is_torn[pair.edge] = 1;
  }
  for (std::size_t k = 0; k < edges.size(); ++k) torn[edges[k].loop] += is_torn[k];
  return torn;
}

}  // namespace

void mark_torn_edges(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                     CloudRim& rim, const TornEdgeOptions& options) {
  require_options("mark_torn_edges", options);
  if (rim.loops.size() < 2) return;  // a rim has to be left
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
