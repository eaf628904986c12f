#include "update/model/irregular_sides.h"

#include <algorithm>

#include "geom/mesh/halfedges.h"

namespace cocoon {

std::vector<EdgeSide> irregular_sides(const ModelIndex& model) {
  std::vector<EdgeSide> sides;
  if (model.is_known_smooth()) return sides;
  const TriangleMesh& mesh = model.mesh();
  for (const TriangleId t : mesh.triangles.ids()) {
    if (repeats_a_vertex(mesh.triangles[t])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!model.neighbors()[t][i].is_none()) continue;
      const auto [a, b] = ends_of_halfedge(mesh, halfedge_of(t, i));
      sides.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace cocoon
