#include "update/lost_triangles.h"

#include <algorithm>

#include "geom/closest_facet.h"
#include "geom/triangles_by_area.h"

namespace cocoon {

LostTriangles lost_triangles(const TriangleMesh& model, const MeshChange& change) {
  LostTriangles result;
  for (const TriangleId t : model.triangles.ids()) {
    const Triangle& corners = model.triangles[t];
    const bool stays = std::none_of(corners.begin(), corners.end(),
                                    [&](VertexId v) { return change.vertex_map[v].is_none(); });
    if (!stays) continue;
    ++result.staying;
    result.staying_area += area_of(model, t);
    if (change.triangle_map[t].is_none()) result.lost.push_back(t);
  }
  return result;
}

double astray_area(const TriangleMesh& model, std::span<const TriangleId> triangles,
                   const TriangleMesh& updated, double tolerance) {
  const ClosestFacetTree tree(updated);
  double area = 0;
  for (const TriangleId t : triangles) {
    const auto [a, b, c] = corners_of(model, t);
    const double limit = tolerance * std::max({distance(a, b), distance(b, c), distance(c, a)});
    const Point middle = a + (1.0 / 3) * ((b - a) + (c - a));
    if (tree.closest(middle).squared_distance > limit * limit) area += area_of(model, t);
  }
  return area;
}

}  // namespace cocoon
