#include "update/cloud/rim_edges.h"

#include <cmath>

#include "geom/search/box_tree.h"
#include "update/cloud/rim_seams.h"
#include "update/model/reached_cells.h"
#include "update/model/sample_heights.h"

namespace cocoon {

namespace {

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

}  // namespace

std::vector<RimEdge> ends_of_cloud(const CloudRim& rim) {
  std::vector<RimEdge> edges;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    const RimLoop& loop = rim.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop.is_inner(i)) continue;
      const Point middle = loop.middle(i);
      edges.push_back({l, i, middle, unit(place_beyond(loop, i, rim.spacing) - middle)});
    }
  }
  return edges;
}

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

std::vector<std::uint8_t> edges_with_steps(const ModelIndex& model,
                                           const std::vector<RimEdge>& edges,
                                           const std::vector<Point>& samples,
                                           const std::vector<SampleBeyond>& beyond,
                                           const StepBounds& bounds) {
  std::vector<std::uint8_t> has_step(edges.size(), 0);
  if (beyond.empty()) return has_step;
  const std::vector<double> heights =
      heights_of_pairs(model, edges, samples, beyond, bounds.farthest);
  for (const SampleBeyond& pair : beyond) {
    const double height = heights[pair.edge];
    const double step = heights[edges.size() + pair.sample] - height;
    if (std::abs(step) > bounds.min_step || height > bounds.off_model) has_step[pair.edge] = 1;
  }
  return has_step;
}

}  // namespace cocoon
