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
  std::vector<std::size_t> torn(rim.loops.size(), 0);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RimEdge& edge = edges[k];
    const double off = around.height_of_edge(k) + options.off_model * rim.spacing;
    const double outward = options.min_outward * rim.spacing;
    torn[edge.loop] += around.any_near(edge.middle, reach, [&](const Point& p, double height) {
      return height > off && dot(p - edge.middle, edge.outward) >= outward;
    });
  }
  const auto is_seam = [&](std::size_t l) {
    const auto& inner = rim.loops[l].inner;
    const auto marked = static_cast<std::size_t>(std::count(inner.begin(), inner.end(), 1));
    return torn[l] > 0 && static_cast<double>(torn[l] + marked) >
                              options.max_seam_share * static_cast<double>(rim.loops[l].size());
  };
  std::vector<std::size_t> seams;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (is_seam(l)) seams.push_back(l);
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
