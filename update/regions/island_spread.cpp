#include "update/regions/island_spread.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "geom/nearest_point.h"
#include "geom/require_size.h"
#include "geom/sort_ids.h"

namespace cocoon {

namespace {

// All that hang together with a facet by edges, without blocked ones. Blocks them.
std::vector<TriangleId> part_around(const ModelIndex& model, TriangleId facet,
                                    TriangleSet& blocked) {
  std::vector<TriangleId> part = {facet};
  blocked[facet] = 1;
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (const TriangleId next : model.neighbors()[part[k]]) {
      if (next.is_none() || blocked[next] != 0) continue;
      blocked[next] = 1;
      part.push_back(next);
    }
  }
  return part;
}

}  // namespace

void spread_on_islands(const ModelIndex& model, const TriangleSet& border, const TriangleSet& under,
                       double reach, double min_share, std::vector<TriangleId>& facets) {
  const std::size_t triangles = model.mesh().triangles.size();
  require_size("spread_on_islands", "flags of the border", border.size(), triangles);
  require_size("spread_on_islands", "flags of facets", under.size(), triangles);
  if (facets.empty()) return;
  TriangleSet blocked = border;
  for (const TriangleId t : blocked.ids()) blocked[t] |= under[t];
  const std::size_t outside = triangles - members(blocked).size();
  std::vector<TriangleId> found = facets;
  for (const TriangleId first : facets) {
    if (blocked[first] != 0) continue;
    const std::vector<TriangleId> part = part_around(model, first, blocked);
    if (2 * part.size() > outside) continue;
    std::vector<Point> places;
    for (const TriangleId t : part) {
      if (std::binary_search(facets.begin(), facets.end(), t)) places.push_back(model.centroid(t));
    }
    if (static_cast<double>(places.size()) <= min_share * static_cast<double>(part.size()))
      continue;
    const NearestPointTree tree(places);
    std::copy_if(part.begin(), part.end(), std::back_inserter(found),
                 [&](TriangleId t) { return tree.any_near(model.centroid(t), reach); });
  }
  make_set(found);
  facets = std::move(found);
}

}  // namespace cocoon
