#include "update/regions/island_spread.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"
#include "geom/search/nearest_point.h"

namespace cocoon {

namespace {

// All that hang together with a facet by edges, without settled ones. Settles them.
std::vector<TriangleId> part_around(const ModelIndex& model, TriangleId facet,
                                    TriangleSet& settled) {
  std::vector<TriangleId> part = {facet};
  settled[facet] = 1;
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (const TriangleId next : model.neighbors()[part[k]]) {
      if (next.is_none() || settled[next] != 0) continue;
      settled[next] = 1;
      part.push_back(next);
    }
  }
  return part;
}

}  // namespace

void spread_on_islands(const ModelIndex& model, TriangleSet settled, double reach, double min_share,
                       std::vector<TriangleId>& facets) {
  require_size("spread_on_islands", "flags of facets", settled.size(),
               model.mesh().triangles.size());
  if (facets.empty()) return;
  const std::span<const std::uint8_t> flags = std::as_const(settled).span();
  const auto outside = static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 0));
  std::vector<TriangleId> found = facets;
  for (const TriangleId first : facets) {
    if (settled[first] != 0) continue;
    const std::vector<TriangleId> part = part_around(model, first, settled);
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
