#include "update/model/euler_number.h"

#include <algorithm>
#include <vector>

#include "geom/search/equal_points.h"

namespace cocoon {
namespace {

std::size_t count_in_pairs(std::span<const EdgeSide> sides) {
  std::size_t edges = 0;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::upper_bound(begin, sides.end(), *begin);
    edges += static_cast<std::size_t>(end - begin + 1) / 2;
    begin = end;
  }
  return edges;
}

}  // namespace

std::size_t repeated_vertices(const ModelIndex& model) {
  if (model.has_distinct_points()) return 0;
  std::vector<Point> places;
  places.reserve(model.mesh().points.size());
  for (const VertexId v : model.mesh().points.ids()) {
    if (model.is_used(v)) places.push_back(model.mesh().points[v]);
  }
  return repeated_points(places).size();
}

std::ptrdiff_t euler_number(const ModelIndex& model, std::span<const EdgeSide> irregular) {
  const TriangleMesh& mesh = model.mesh();
  std::size_t vertices = mesh.points.size() - repeated_vertices(model);
  if (model.is_known_smooth()) {
    return euler_number(vertices, mesh.triangles.size());
  }
  for (const VertexId v : mesh.points.ids()) vertices -= model.is_used(v) ? 0U : 1U;
  const auto improper = static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), repeats_a_vertex));
  const std::size_t triangles = mesh.triangles.size() - improper;
  const std::size_t edges = (3 * triangles - irregular.size()) / 2 + count_in_pairs(irregular);
  return static_cast<std::ptrdiff_t>(vertices + triangles) - static_cast<std::ptrdiff_t>(edges);
}

}  // namespace cocoon
