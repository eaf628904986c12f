#include "cocone/noise/floating_clumps.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/noise/sample_parts.h"
#include "cocone/samples/sample_spacing.h"
#include "geom/arrays/sort_ids.h"

namespace cocoon {
namespace {

std::vector<VertexId> bad_samples(const VertexSet& good) {
  std::vector<VertexId> bad;
  for (const VertexId v : good.ids()) {
    if (good[v] == 0) bad.push_back(v);
  }
  return bad;
}

// How far the links of bad samples reach, and of their neighbors; nothing is asked about others.
IdVector<VertexId, double> reach_of_links(const Triangulation& triangulation,
                                          const VertexStars& stars,
                                          const IdVector<VertexId, double>& spacing,
                                          const std::vector<VertexId>& bad, double ratio,
                                          const Execution& execution) {
  VertexSet is_asked(triangulation.num_vertices(), 0);
  std::vector<VertexId> asked;
  std::vector<VertexId> around;
  const auto ask = [&](VertexId v) {
    if (is_asked[v] == 0) asked.push_back(v);
    is_asked[v] = 1;
  };
  for (const VertexId v : bad) {
    ask(v);
    collect_neighbors(triangulation, stars.star(v), v, around);
    for (const VertexId w : around) ask(w);
  }
  IdVector<VertexId, double> reach = usual_spacing(triangulation, stars, spacing, asked, execution);
  for (const VertexId v : asked) reach[v] *= ratio;
  return reach;
}

// The bad samples that more than so many links part from every good one: a search by whole levels,
// from the good ones.
std::vector<VertexId> deep_samples(const Triangulation& triangulation, const VertexStars& stars,
                                   const IdVector<VertexId, double>& reach,
                                   std::vector<VertexId> bad, const VertexSet& good,
                                   std::size_t links) {
  VertexSet near = good;
  std::vector<VertexId> around;
  const auto linked_neighbors = [&](VertexId v) -> const std::vector<VertexId>& {
    collect_neighbors(triangulation, stars.star(v), v, around);
    std::erase_if(around, [&](VertexId w) { return !is_linked(triangulation, reach, v, w); });
    return around;
  };
  std::vector<VertexId> level;
  for (const VertexId v : bad) {
    const auto& linked = linked_neighbors(v);
    const bool is_next =
        std::any_of(linked.begin(), linked.end(), [&](VertexId w) { return good[w] != 0; });
    if (links > 0 && is_next) level.push_back(v);
  }
  for (std::size_t reached = 1; !level.empty(); ++reached) {
    for (const VertexId v : level) near[v] = 1;
    std::vector<VertexId> next;
    for (const VertexId v : level) {
      if (reached == links) break;
      for (const VertexId w : linked_neighbors(v)) {
        if (near[w] == 0) next.push_back(w);
      }
    }
    make_set(next);
    level = std::move(next);
  }
  std::erase_if(bad, [&](VertexId v) { return near[v] != 0; });
  return bad;
}

}  // namespace

FloatingClumps floating_clumps(const Triangulation& triangulation, const VertexStars& stars,
                               const IdVector<VertexId, double>& spacing, const VertexSet& good,
                               const NoiseOptions& options, const Execution& execution) {
  const std::size_t all = triangulation.num_vertices();
  FloatingClumps result;
  result.out = VertexSet(all, 0);
  const std::vector<VertexId> bad = bad_samples(good);
  if (options.clump_share <= 0 || bad.empty() || bad.size() == all) return result;
  const IdVector<VertexId, double> reach =
      reach_of_links(triangulation, stars, spacing, bad, options.clump_link_ratio, execution);
  const std::vector<VertexId> far =
      deep_samples(triangulation, stars, reach, bad, good, options.clump_depth);
  if (far.empty()) return result;

  const SampleParts parts = sample_parts(triangulation, reach, good);
  IdVector<VertexId, std::size_t> deep(all, 0);  // samples of each part
  for (const VertexId v : far) {
    const VertexId part = parts.part[v];
    const std::size_t size = parts.size[part];
    const bool is_clump =
        size > options.neighbors &&
        static_cast<double>(size) < options.clump_share * static_cast<double>(all);
    if (!is_clump) continue;
    result.out[v] = 1;
    ++result.samples;
    result.clumps += deep[part]++ == 0 ? 1U : 0U;
    result.largest = std::max(result.largest, deep[part]);
  }
  for (const VertexId v : far) {
    if (result.out[v] == 0 || deep[parts.part[v]] < result.largest) continue;
    if (result.at.is_none() || triangulation.point(v) < triangulation.point(result.at)) {
      result.at = v;
    }
  }
  return result;
}

}  // namespace cocoon
