#include "cocone/prune_part.h"

#include <algorithm>

namespace cocoon {
namespace {

// Smallest cosine = largest dihedral among the triangles at an edge that are not removed; above
// every limit for one.
double flattest_cosine(const LinkedFacets& links, SideId side,
                       const std::vector<std::uint8_t>& removed) {
  double flattest = 2;
  for_each_side_at_edge(links, side, [&](SideId a) {
    if (removed[triangle_of_side(a)] != 0) return;
    for_each_side_at_edge(links, side, [&](SideId b) {
      if (b <= a || removed[triangle_of_side(b)] != 0) return;
      flattest = std::min(flattest, dihedral_cosine(links, a, b));
    });
  });
  return flattest;
}

}  // namespace

std::vector<std::uint8_t> prune_part(const LinkedFacets& triangles, const VertexSet& core,
                                     const VertexSet& umbrella, const PruneOptions& options) {
  const auto is_complete = [&](SideId side) {
    const auto [a, b] = triangles.ends(side);
    return core[a] != 0 || core[b] != 0;
  };
  const auto is_guarded = [&](SideId side) {
    const auto [a, b] = triangles.ends(side);
    return umbrella[a] != 0 && umbrella[b] != 0;
  };
  std::vector<std::uint8_t> removed(triangles.size(), 0);
  std::vector<std::uint8_t> kept(triangles.size(), 0);
  std::vector<SideId> work;
  for_each_edge(triangles, 0, triangles.size(), [&](SideId side) {
    if (!is_complete(side)) return;
    const double flattest = flattest_cosine(triangles, side, removed);
    if (triangles.is_two_sided(side) && flattest <= options.keep_cosine) {
      kept[triangle_of_side(side)] = 1;
      kept[triangle_of_side(triangles.links[side])] = 1;
    }
    if (flattest > options.sharp_cosine && is_guarded(side)) work.push_back(side);
  });
  while (!work.empty()) {
    const SideId side = work.back();
    work.pop_back();
    if (flattest_cosine(triangles, side, removed) <= options.sharp_cosine) continue;
    for_each_side_at_edge(triangles, side, [&](SideId at) {
      const std::uint32_t t = triangle_of_side(at);
      if (kept[t] != 0 || removed[t] != 0) return;
      removed[t] = 1;
      for (SideId other = 3 * t; other < 3 * t + 3; ++other) {
        if (is_complete(other) && is_guarded(other)) work.push_back(other);
      }
    });
  }
  return removed;
}

}  // namespace cocoon
