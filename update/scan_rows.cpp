#include "update/scan_rows.h"

#include <algorithm>
#include <array>

#include "geom/arrays/median.h"
#include "geom/mesh/triangles_at_vertices.h"
#include "geom/messages/require_size.h"
#include "geom/search/thin_points.h"

namespace cocoon {

namespace {

// Squared: the shortest edge, and the second longest.
std::array<double, 2> squared_edges(const TriangleMesh& surface, const Triangle& t) {
  const Point& a = surface.points[t[0]];
  const Point& b = surface.points[t[1]];
  const Point& c = surface.points[t[2]];
  const double ab = squared_distance(a, b);
  const double bc = squared_distance(b, c);
  const double ca = squared_distance(c, a);
  // Without a branch: which edge is longer cannot be foreseen.
  const double shorter = std::min(ab, bc);
  const double longer = std::max(ab, bc);
  return {std::min(shorter, ca), std::max(shorter, std::min(longer, ca))};
}

// Squared, per point of the cloud.
std::vector<double> squared_row_distances(std::size_t points, const TriangleMesh& surface,
                                          const IdVector<VertexId, PointId>& point_of_vertex,
                                          double quantile) {
  std::vector<double> numbers;
  const auto add = [&](const Triangle& t) {
    const auto [shortest, middle] = squared_edges(surface, t);
    if (shortest > 0) numbers.push_back(middle);
  };
  for (const Triangle& t : surface.triangles) add(t);
  std::vector<double> at(points, quantile_in_place(numbers, quantile));
  const TrianglesAtVertices at_vertices = triangles_at_vertices(surface);
  for (const VertexId v : surface.points.ids()) {
    numbers.clear();
    for (const TriangleId t : at_vertices[v]) add(surface.triangles[t]);
    double& here = at[point_of_vertex[v].index()];
    here = std::max(here, quantile_in_place(numbers, quantile));
  }
  return at;
}

}  // namespace

bool lies_in_rows(const TriangleMesh& surface, const RowOptions& options) {
  const double min_ratio = options.min_ratio;
  if (!(min_ratio > 0)) return false;
  std::size_t counted = 0;
  std::size_t across = 0;
  for (const Triangle& t : surface.triangles) {
    const auto [shortest, middle] = squared_edges(surface, t);
    if (shortest == 0) continue;
    ++counted;
    across += middle >= min_ratio * min_ratio * shortest ? 1U : 0U;
  }
  return counted > 0 &&
         static_cast<double>(across) >= options.min_share * static_cast<double>(counted);
}

std::vector<PointId> thin_out_rows(Points cloud, const TriangleMesh& surface,
                                   const IdVector<VertexId, PointId>& point_of_vertex,
                                   const RowOptions& options) {
  require_size("thin_out_rows", "points of vertices", point_of_vertex.size(),
               surface.points.size());
  const std::vector<double> distances =
      squared_row_distances(cloud.size(), surface, point_of_vertex, options.quantile);
  const double spread = options.spread;
  return thin_points(cloud, [&](PointId p) { return spread * spread * distances[p.index()]; });
}

}  // namespace cocoon
