#include "cocone/prune_patch.h"

#include <algorithm>
#include <vector>

#include "cocone/linked_facets.h"
#include "cocone/umbrella.h"

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

// Triangles with an edge off the core end as they did before; those without a core vertex are taken
// for what they were. As long as the former hold, the latter do, and nothing is pruned there that
// was not: the greatest fixed point of the part and what is known around it make that of the whole.
bool agrees_at_the_rim(const LocalPatch& patch, const LinkedFacets& links,
                       const std::vector<std::uint8_t>& removed,
                       const IdVector<CellId, std::uint8_t>& known) {
  for (std::uint32_t t = 0; t < links.size(); ++t) {
    int in_core = 0;
    for (const VertexId v : links.corners[t]) in_core += patch.is_core[v];
    if (in_core != 1) continue;
    const FacetId f = links.facets[t];
    const CellId slot = patch.slot_of_cell[cell_of(f)];
    if (slot.index() >= known.size()) return false;
    if (((known[slot] >> index_of(f)) & 1) != removed[t]) return false;
  }
  return true;
}

}  // namespace

std::optional<FacetSet> prune_patch(const LocalPatch& patch, const FacetSet& candidates,
                                    const IdVector<CellId, std::uint8_t>& known,
                                    const PruneOptions& options, const Execution& execution) {
  const LinkedFacets links = link_facets(patch.triangulation, candidates, execution);
  const VertexSet umbrella = vertices_with_umbrella(links, patch.triangulation.num_vertices(),
                                                    options.sharp_cosine, execution);
  for (const VertexId v : patch.triangulation.vertices()) {
    if (patch.is_core[v] != 0 && umbrella[v] == 0) return std::nullopt;
  }
  const auto is_complete = [&](SideId side) {
    const auto [a, b] = links.ends(side);
    return patch.is_core[a] != 0 || patch.is_core[b] != 0;
  };
  std::vector<std::uint8_t> removed(links.size(), 0);
  std::vector<std::uint8_t> kept(links.size(), 0);
  std::vector<SideId> work;
  for_each_edge(links, 0, links.size(), [&](SideId side) {
    if (!is_complete(side)) return;
    const double flattest = flattest_cosine(links, side, removed);
    if (links.is_two_sided(side) && flattest <= options.keep_cosine) {
      kept[triangle_of_side(side)] = 1;
      kept[triangle_of_side(links.links[side])] = 1;
    }
    if (flattest > options.sharp_cosine) work.push_back(side);
  });
  while (!work.empty()) {
    const SideId side = work.back();
    work.pop_back();
    if (flattest_cosine(links, side, removed) <= options.sharp_cosine) continue;
    for_each_side_at_edge(links, side, [&](SideId at) {
      const std::uint32_t t = triangle_of_side(at);
      if (kept[t] != 0 || removed[t] != 0) return;
      removed[t] = 1;
      for (SideId other = 3 * t; other < 3 * t + 3; ++other) {
        if (is_complete(other)) work.push_back(other);
      }
    });
  }
  if (!agrees_at_the_rim(patch, links, removed, known)) return std::nullopt;
  FacetSet left = candidates;
  for (std::uint32_t t = 0; t < links.size(); ++t) {
    const FacetId f = links.facets[t];
    const bool off_core = std::none_of(links.corners[t].begin(), links.corners[t].end(),
                                       [&](VertexId v) { return patch.is_core[v] != 0; });
    const CellId slot = patch.slot_of_cell[cell_of(f)];
    const bool gone = off_core
                          ? slot.index() < known.size() && ((known[slot] >> index_of(f)) & 1) != 0
                          : removed[t] != 0;
    if (gone) left.erase(patch.triangulation, f);
  }
  return left;
}

}  // namespace cocoon
