#include "docs/pictures/plane_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace cocoon::pictures {
namespace {

// Where the plane meets the edges between these points, each place once.
std::vector<Planar> crossings(std::span<const Point> corners) {
  std::vector<Planar> found;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    if (a.z == 0) found.push_back({a.x, a.y});
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const Point& b = corners[j];
      if ((a.z < 0 && b.z > 0) || (a.z > 0 && b.z < 0)) {
        const double t = a.z / (a.z - b.z);
        found.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
  }
  return found;
}

void sort_around_middle(std::vector<Planar>& corners) {
  Planar middle;
  for (const Planar& p : corners) middle = middle + p;
  middle = (1 / static_cast<double>(corners.size())) * middle;
  const auto angle = [&](const Planar& p) { return std::atan2(p.y - middle.y, p.x - middle.x); };
  std::sort(corners.begin(), corners.end(),
            [&](const Planar& a, const Planar& b) { return angle(a) < angle(b); });
}

}  // namespace

std::vector<Planar> section_of_cell(const Triangulation& triangulation, CellId c) {
  std::array<Point, 4> corners;
  for (int i = 0; i < 4; ++i) {
    corners[static_cast<std::size_t>(i)] = triangulation.point(triangulation.vertex(c, i));
  }
  std::vector<Planar> polygon = crossings(corners);
  if (polygon.size() < 3) return {};
  sort_around_middle(polygon);
  return polygon;
}

std::optional<std::pair<Planar, Planar>> section_of_facet(const Triangulation& triangulation,
                                                          FacetId f) {
  std::array<Point, 3> corners;
  const auto vertices = triangulation.facet_vertices(f);
  for (std::size_t i = 0; i < 3; ++i) corners[i] = triangulation.point(vertices[i]);
  const std::vector<Planar> ends = crossings(corners);
  if (ends.size() != 2) return std::nullopt;
  return std::pair(ends[0], ends[1]);
}

std::vector<Planar> clipped(std::span<const Planar> polygon, Planar normal, double limit) {
  std::vector<Planar> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Planar& a = polygon[i];
    const Planar& b = polygon[(i + 1) % polygon.size()];
    const double at_a = dot(normal, a) - limit;
    const double at_b = dot(normal, b) - limit;
    if (at_a <= 0) kept.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
      kept.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    }
  }
  return kept;
}

std::vector<Planar> section_of_voronoi_cell(const Triangulation& triangulation,
                                            const VertexStars& stars, VertexId v, double reach) {
  const Point& p = triangulation.point(v);
  std::vector<Planar> polygon = {{p.x - reach, p.y - reach},
                                 {p.x + reach, p.y - reach},
                                 {p.x + reach, p.y + reach},
                                 {p.x - reach, p.y + reach}};
  for (const CellId c : stars.star(v)) {
    for (const VertexId w : triangulation.cell(c).vertices) {
      if (w == v || w == infinite_vertex) continue;
      // Closer to p than to q: 2 (q - p) x <= |q|^2 - |p|^2.
      const Point& q = triangulation.point(w);
      polygon =
          clipped(polygon, {2 * (q.x - p.x), 2 * (q.y - p.y)}, squared_norm(q) - squared_norm(p));
    }
  }
  return polygon.size() < 3 ? std::vector<Planar>{} : polygon;
}

}  // namespace cocoon::pictures
