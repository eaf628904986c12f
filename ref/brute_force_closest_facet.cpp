#include "ref/brute_force_closest_facet.h"

#include <algorithm>
#include <array>

#include "geom/errors.h"

namespace cocoon::ref {
namespace {

Point closest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Vec3 along = b - a;
  const double length = squared_norm(along);
  if (length == 0) return a;
  const double t = std::clamp(dot(p - a, along) / length, 0.0, 1.0);
  return a + t * along;
}

Point closest_on_triangle(const Point& p, const std::array<Point, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = unit(cross(b - a, c - a));
  const Point foot = p - dot(p - a, normal) * normal;
  const auto left_of = [&](const Point& from, const Point& to) {
    return dot(cross(to - from, foot - from), normal) > 0;
  };
  if (left_of(a, b) && left_of(b, c) && left_of(c, a)) return foot;
  Point best = closest_on_segment(p, a, b);
  for (const Point& other : {closest_on_segment(p, b, c), closest_on_segment(p, c, a)}) {
    if (squared_distance(p, other) < squared_distance(p, best)) best = other;
  }
  return best;
}

}  // namespace

ClosestFacet brute_force_closest_facet(const TriangleMesh& mesh, const Point& p) {
  if (mesh.triangles.empty()) throw InputError("mesh has no triangles; give a surface");
  ClosestFacet best;
  std::array<Point, 3> best_corners;
  for (const TriangleId t : mesh.triangles.ids()) {
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.points[mesh.triangles[t][i]];
    std::sort(corners.begin(), corners.end(),
              [](const Point& a, const Point& b) { return (a <=> b) < 0; });
    const Point candidate = closest_on_triangle(p, corners);
    const double squared = squared_distance(p, candidate);
    const bool wins = best.triangle.is_none() || squared < best.squared_distance ||
                      (squared == best.squared_distance && corners < best_corners);
    if (!wins) continue;
    best = {t, candidate, squared};
    best_corners = corners;
  }
  return best;
}

}  // namespace cocoon::ref
