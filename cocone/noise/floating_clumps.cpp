#include "cocone/noise/floating_clumps.h"

#include <algorithm>
#include <vector>

#include "cocone/noise/sample_parts.h"
#include "cocone/samples/sample_spacing.h"

namespace cocoon {
namespace {

// 1 = within so many links of a good sample.
VertexSet near_good(const Triangulation& triangulation, const VertexStars& stars,
                    const IdVector<VertexId, double>& reach, const VertexSet& good,
                    std::size_t links) {
  VertexSet near = good;
  std::vector<VertexId> front;
  for (const VertexId v : triangulation.vertices()) {
    if (good[v] != 0) front.push_back(v);
  }
  std::vector<VertexId> next;
  std::vector<VertexId> around;
  for (; links > 0 && !front.empty(); --links) {
    next.clear();
    for (const VertexId v : front) {
      collect_neighbors(triangulation, stars.star(v), v, around);
      for (const VertexId w : around) {
        if (near[w] != 0 || !is_linked(triangulation, reach, v, w)) continue;
        near[w] = 1;
        next.push_back(w);
      }
    }
    front.swap(next);
  }
  return near;
}

}  // namespace

FloatingClumps floating_clumps(const Triangulation& triangulation, const VertexStars& stars,
                               const IdVector<VertexId, double>& spacing, const VertexSet& good,
                               const NoiseOptions& options, const Execution& execution) {
  const std::size_t all = triangulation.num_vertices();
  FloatingClumps result;
  result.out = VertexSet(all, 0);
  const bool any_good = std::find(good.begin(), good.end(), 1) != good.end();
  if (options.clump_share <= 0 || !any_good) return result;
  IdVector<VertexId, double> reach = usual_spacing(triangulation, stars, spacing, execution);
  for (const VertexId v : triangulation.vertices()) reach[v] *= options.clump_link_ratio;
  const VertexSet near = near_good(triangulation, stars, reach, good, options.clump_depth);
  if (std::find(near.begin(), near.end(), 0) == near.end()) return result;

  const SampleParts parts = sample_parts(triangulation, reach, good);
  IdVector<VertexId, std::size_t> deep(all, 0);  // samples of each part
  for (const VertexId v : triangulation.vertices()) {
    const VertexId part = parts.part[v];
    const std::size_t size = parts.size[part];
    const bool is_clump =
        size > options.neighbors &&
        static_cast<double>(size) < options.clump_share * static_cast<double>(all);
    if (near[v] != 0 || !is_clump) continue;
    result.out[v] = 1;
    ++result.samples;
    result.clumps += deep[part]++ == 0 ? 1U : 0U;
    result.largest = std::max(result.largest, deep[part]);
  }
  for (const VertexId v : triangulation.vertices()) {
    if (result.out[v] == 0 || deep[parts.part[v]] < result.largest) continue;
    if (result.at.is_none() || triangulation.point(v) < triangulation.point(result.at)) {
      result.at = v;
    }
  }
  return result;
}

}  // namespace cocoon
