#include "cocone/live/known_surface.h"

#include <cassert>
#include <cstddef>
#include <vector>

#include "geom/parallel/parallel_list.h"

namespace cocoon {
namespace {

std::vector<FacetId> outer_halves(const IdVector<CellId, std::uint8_t>& sides,
                                  const Execution& execution) {
  constexpr std::size_t cells_per_chunk = std::size_t{1} << 14;
  return parallel_list<FacetId>(
      execution, sides.size(), cells_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<FacetId>& found) {
        for (CellId c(begin); c.index() < end; ++c) {
          for (int i = 0; i < 4; ++i) {
            if ((sides[c] & (side_flag::outer << i)) != 0) found.push_back(facet_id(c, i));
          }
        }
      });
}

}  // namespace

SurfaceMesh known_surface(const Triangulation& triangulation, const SurfaceState& state,
                          const Execution& execution) {
  assert(state.has_surface());
  if (state.sides.empty()) return surface_between(triangulation, state.out, execution);
  return surface_of(triangulation, outer_halves(state.sides, execution), execution);
}

}  // namespace cocoon
