#include "geom/triangle_projection.h"

#include <algorithm>
#include <cstddef>

#include "geom/triangle_normal.h"

namespace cocoon {

namespace {

// Twice the area of a triangle by the square of its longest edge, and the sine of its largest
// angle. A cross product of two edges is off by some 2^-52 of the product of their lengths: below
// the one it is taken of the shorter two, below the other its direction is anything.
constexpr double least_area = 0x1p-26;
constexpr double least_sine = 0x1p-26;

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

// The corner opposite the longest edge; of equal ones the first.
std::size_t corner_of_largest_angle(const TrianglePoints& t) {
  const std::array<double, 3> opposite = {
      squared_distance(t[1], t[2]), squared_distance(t[2], t[0]), squared_distance(t[0], t[1])};
  return static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) -
                                  opposite.begin());
}

// From the two shorter edges, and for both of the coordinates that belong to them.
PlaneProjection project_to_narrow(const Point& p, const TrianglePoints& triangle) {
  const std::size_t corner = corner_of_largest_angle(triangle);
  const std::size_t next = (corner + 1) % 3;
  const std::size_t last = (corner + 2) % 3;
  const Vec3 to_next = triangle[next] - triangle[corner];
  const Vec3 to_last = triangle[last] - triangle[corner];
  const Vec3 area = cross(to_next, to_last);
  PlaneProjection result;
  result.normal = unit(area);
  if (!(norm(area) > least_sine * (norm(to_next) * norm(to_last))) || result.normal == Vec3{}) {
    result.normal = {};
    result.degenerate = true;
    return result;
  }
  const Vec3 to_p = p - triangle[corner];
  result.signed_distance = dot(to_p, result.normal);
  result.projected = p - result.signed_distance * result.normal;
  const double squared_area = squared_norm(area);
  result.barycentric[next] = dot(cross(to_p, to_last), area) / squared_area;
  result.barycentric[last] = dot(cross(to_next, to_p), area) / squared_area;
  result.barycentric[corner] = 1 - result.barycentric[next] - result.barycentric[last];
  return result;
}

}  // namespace

PlaneProjection project_to_triangle_plane(const Point& p, const TrianglePoints& triangle) {
  const auto& [v0, v1, v2] = triangle;
  const Vec3 area = area_normal(v0, v1, v2);
  const double squared_edge =
      std::max({squared_norm(v1 - v0), squared_norm(v2 - v1), squared_norm(v0 - v2)});
  if (!(norm(area) > least_area * squared_edge)) return project_to_narrow(p, triangle);
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

TriangleFeature renumbered(TriangleFeature feature, const std::array<std::size_t, 3>& order) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (feature == vertex_features[i]) return vertex_features[order[i]];
    // An edge is known by the corner opposite it.
    if (feature == edge_features[i]) return edge_features[(order[(i + 2) % 3] + 1) % 3];
  }
  return feature;
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
