#include "geom/triangle_projection.h"

#include <cstddef>

namespace cocoon {

namespace {

constexpr std::array<TriangleFeature, 3> vertex_features = {
    TriangleFeature::vertex0, TriangleFeature::vertex1, TriangleFeature::vertex2};
constexpr std::array<TriangleFeature, 3> edge_features = {
    TriangleFeature::edge01, TriangleFeature::edge12, TriangleFeature::edge20};

// The closest point on the edge from vertex i to the next one.
ClosestPoint closest_on_edge(const Point& p, const TrianglePoints& triangle, std::size_t i) {
  const std::size_t next = (i + 1) % 3;
  const Point& from = triangle[i];
  const Vec3 along = triangle[next] - from;
  const double squared_length = squared_norm(along);
  const double t = dot(p - from, along);
  if (!(t > 0)) return {from, vertex_features[i], squared_distance(p, from)};
  if (t >= squared_length)
    return {triangle[next], vertex_features[next], squared_distance(p, triangle[next])};
  const Point point = from + (t / squared_length) * along;
  return {point, edge_features[i], squared_distance(p, point)};
}

}  // namespace

PlaneProjection project_to_triangle_plane(const Point& p, const TrianglePoints& triangle) {
  const auto& [v0, v1, v2] = triangle;
  const Vec3 area = cross(v1 - v0, v2 - v0);
  PlaneProjection result;
  result.normal = unit(area);  // Eq. 1
  if (result.normal == Vec3{}) {
    result.degenerate = true;
    return result;
  }
  result.signed_distance = dot(p - v1, result.normal);            // Eq. 2
  result.projected = p - result.signed_distance * result.normal;  // Eq. 3
  // Areas of the three triangles at p_proj; moving p along n does not change them, so p itself
  // serves and a rounding of p_proj does not enter.
  const double squared_area = squared_norm(area);
  result.barycentric = {dot(cross(v2 - v1, p - v1), area) / squared_area,
                        dot(cross(v0 - v2, p - v2), area) / squared_area,
                        dot(cross(v1 - v0, p - v0), area) / squared_area};
  return result;
}

// If p projects into the triangle, the projection is closest. Otherwise the closest point lies on
// the border; the nearest of the three edges' points is it, vertices before edges on ties.
ClosestPoint closest_point_on_triangle(const Point& p, const TrianglePoints& triangle) {
  const PlaneProjection plane = project_to_triangle_plane(p, triangle);
  if (plane.is_inside()) {
    const bool on_border =
        plane.barycentric[0] == 0 || plane.barycentric[1] == 0 || plane.barycentric[2] == 0;
    if (!on_border) {
      return {plane.projected, TriangleFeature::interior, squared_distance(p, plane.projected)};
    }
  }
  ClosestPoint best = closest_on_edge(p, triangle, 0);
  for (std::size_t i = 1; i < 3; ++i) {
    const ClosestPoint candidate = closest_on_edge(p, triangle, i);
    if (candidate.squared_distance < best.squared_distance ||
        (candidate.squared_distance == best.squared_distance && candidate.feature < best.feature))
      best = candidate;
  }
  return best;
}

}  // namespace cocoon
