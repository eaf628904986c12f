#include "cocone/marking/old_triangles.h"

#include <algorithm>
#include <utility>

#include "cocone/facets/edge_cycle.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

OldTriangles::OldTriangles(const Triangulation& triangulation,
                           std::span<const KnownTriangle> triangles, const Execution& execution)
    : triangulation_(triangulation),
      facet_of_(triangles.size()),
      facets_(triangulation.num_cells()) {
  begins_ = sort_by_vertex(
      triangles.size(), triangulation.num_vertices(), execution,
      [&](std::size_t count) { spokes_.resize(count); },
      [&](std::size_t begin, std::size_t end, const auto& put) {
        for (std::size_t t = begin; t < end; ++t) {
          Triangle corners;
          std::transform(triangles[t].begin(), triangles[t].end(), corners.begin(),
                         [&](PointId p) { return triangulation.vertex_of_point()[p]; });
          for (std::size_t k = 0; k < 3; ++k) {
            put(corners[k], [&](std::uint32_t place) {
              spokes_[place] = {corners[(k + 1) % 3], corners[(k + 2) % 3],
                                static_cast<std::uint32_t>(t)};
            });
          }
        }
      });
}

void OldTriangles::find(FacetId f, std::vector<Found>& found) const {
  const auto [x, y, z] = triangulation_.facet_vertices(f);
  bool met[2] = {};
  for (const Spoke& spoke : fan(x)) {
    const bool ahead = spoke.from == y && spoke.to == z;
    if (!ahead && (spoke.from != z || spoke.to != y)) continue;
    if (std::exchange(met[ahead ? 1 : 0], true)) continue;
    const FacetId behind = ahead ? f : triangulation_.mirror(f);
    if (!triangulation_.is_infinite(cell_of(behind))) found.push_back({behind, spoke.triangle});
  }
}

bool OldTriangles::is_intact(VertexId v) const {
  const std::span<const Spoke> spokes = fan(v);
  return !spokes.empty() && std::all_of(spokes.begin(), spokes.end(), [&](const Spoke& s) {
    return !facet_of_[s.triangle].is_none();
  }) && (is_one_cycle(spokes) || is_balanced(spokes));
}

bool OldTriangles::is_closed(VertexId v) const { return is_corner(v) && is_balanced(fan(v)); }

bool OldTriangles::is_balanced(std::span<const Spoke> fan) {
  const auto count = [&](VertexId Spoke::*end, VertexId w) {
    return std::count_if(fan.begin(), fan.end(), [&](const Spoke& s) { return s.*end == w; });
  };
  return std::all_of(fan.begin(), fan.end(), [&](const Spoke& s) {
    return count(&Spoke::from, s.to) == count(&Spoke::to, s.to);
  });
}

}  // namespace cocoon
