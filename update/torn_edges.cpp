#include "update/torn_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geom/box_tree.h"
#include "update/near_facets.h"
#include "update/reached_cells.h"
#include "update/rim_seams.h"

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

// How far places are from the model, and which samples lie around.
class Surroundings {
 public:
  Surroundings(const ModelIndex& model, std::vector<Point> samples,
               const std::vector<RimEdge>& edges, double bound)
      : samples_(std::move(samples)), bound_(bound) {
    std::vector<Point> places = samples_;
    for (const RimEdge& edge : edges) places.push_back(edge.middle);
    const NearFacets near(model, places, bound);
    for (const Point& p : places) {
      const ClosestFacet closest = near.closest(p, bound * bound, [](TriangleId) { return true; });
      heights_.push_back(closest.triangle.is_none() ? bound : std::sqrt(closest.squared_distance));
    }
    std::vector<Box> boxes;
    for (const Point& p : samples_) boxes.push_back(box_of({&p, 1}));
    tree_ = BoxTree(boxes);
  }

  double height_of_edge(std::size_t k) const { return heights_[samples_.size() + k]; }
  // Whether holds(sample, its height) for some sample within that distance.
  template <class Holds>
  bool any_near(const Point& p, double reach, const Holds& holds) const {
    bool found = false;
    tree_.visit_near(p, reach * reach, [&](std::uint32_t slot) {
      const std::uint32_t k = tree_.items()[slot];
      found = found || (squared_distance(p, samples_[k]) <= reach * reach &&
                        holds(samples_[k], heights_[k]));
      return found ? -1.0 : reach * reach;
    });
    return found;
  }

 private:
  std::vector<Point> samples_;
  double bound_;
  std::vector<double> heights_;  // of samples, then of edges
  BoxTree tree_;
};

// Whether there are loops that are none.
bool find_seams(std::vector<RimLoop>& loops, double max_share) {
  bool any_rim = false;
  for (RimLoop& loop : loops) {
    const auto inner = static_cast<double>(std::count(loop.inner.begin(), loop.inner.end(), 1));
    loop.is_seam = inner > max_share * static_cast<double>(loop.size());
    if (loop.is_seam) loop.inner.assign(loop.size(), 1);
    any_rim = any_rim || !loop.is_seam;
  }
  return any_rim;
}

}  // namespace

void mark_torn_edges(const ModelIndex& model, Points cloud, CloudRim& rim,
                     const TornEdgeOptions& options) {
  const std::vector<RimEdge> edges = edges_to_ask(rim);
  if (edges.empty()) return;
  std::vector<Point> middles;
  for (const RimEdge& edge : edges) middles.push_back(edge.middle);
  const double reach = options.reach * rim.spacing;
  std::vector<Point> samples = points_near(cloud, middles, reach);
  if (samples.empty()) return;
  const Surroundings around(model, std::move(samples), edges, 2 * reach);
  std::vector<RimLoop> loops = rim.loops;
  std::size_t marked = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RimEdge& edge = edges[k];
    const double off = around.height_of_edge(k) + options.off_model * rim.spacing;
    const double outward = options.min_outward * rim.spacing;
    const bool torn = around.any_near(edge.middle, reach, [&](const Point& p, double height) {
      return height > off && dot(p - edge.middle, edge.outward) >= outward;
    });
    if (!torn) continue;
    loops[edge.loop].inner.resize(loops[edge.loop].size(), 0);
    loops[edge.loop].inner[edge.index] = 1;
    ++marked;
  }
  if (marked == 0 || !find_seams(loops, options.max_seam_share)) return;
  rim.loops = std::move(loops);
  rim.seam_edges += marked;
  rim.torn_edges = marked;
}

}  // namespace cocoon
