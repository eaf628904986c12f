#include "update/report/closed_openings.h"

#include <algorithm>
#include <vector>

#include "geom/messages/require_size.h"
#include "update/model/irregular_sides.h"

namespace cocoon {

ClosedOpenings closed_openings(const ModelIndex& model,
                               const IdVector<VertexId, VertexId>& vertex_map) {
  require_size("closed_openings", "vertices of the map", vertex_map.size(),
               model.mesh().points.size());
  ClosedOpenings found;
  const std::vector<Side> sides = irregular_sides(model);
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::upper_bound(begin, sides.end(), *begin);
    const bool stays = !vertex_map[begin->low].is_none() && !vertex_map[begin->high].is_none();
    if (end - begin == 1 && stays && found.edges++ == 0) found.at = begin->low;
    begin = end;
  }
  return found;
}

}  // namespace cocoon
