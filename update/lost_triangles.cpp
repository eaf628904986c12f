#include "update/lost_triangles.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/closest_facet.h"
#include "geom/sort_by_vertex.h"
#include "geom/triangle_order.h"

namespace cocoon {
namespace {

double area_of(const TriangleMesh& mesh, TriangleId t) {
  const auto [a, b, c] = corners_of(mesh, t);
  return norm(cross(b - a, c - a)) / 2;
}

}  // namespace

LostTriangles lost_triangles(const TriangleMesh& model,
                             const IdVector<VertexId, VertexId>& vertex_map,
                             const TriangleMesh& updated) {
  // The triangles of the updated mesh by their smallest vertices.
  std::vector<Triangle> triangles;
  const std::vector<std::uint32_t> begins = sort_by_vertex(
      updated.triangles.size(), updated.points.size(), {},
      [&](std::size_t count) { triangles.resize(count); },
      [&](std::size_t begin, std::size_t end, const auto& put) {
        for (TriangleId t(begin); t.index() < end; ++t) {
          const Triangle triangle = smallest_first(updated.triangles[t]);
          put(triangle[0], [&](std::uint32_t place) { triangles[place] = triangle; });
        }
      });
  LostTriangles result;
  for (const TriangleId t : model.triangles.ids()) {
    Triangle triangle = model.triangles[t];
    for (VertexId& v : triangle) v = vertex_map[v];
    if (std::any_of(triangle.begin(), triangle.end(), [](VertexId v) { return v.is_none(); })) {
      continue;
    }
    ++result.staying;
    result.staying_area += area_of(model, t);
    triangle = smallest_first(triangle);
    const std::size_t first = begins[triangle[0].index()];
    const auto here = std::span(triangles).subspan(first, begins[triangle[0].index() + 1] - first);
    if (std::find(here.begin(), here.end(), triangle) == here.end()) result.lost.push_back(t);
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
