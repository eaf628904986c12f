#include "io/triangulate_polygon.h"

#include <cmath>
#include <cstddef>

namespace cocoon {

namespace {

struct Planar {
  double x = 0;
  double y = 0;
};

// Twice the signed area of a, b, c.
double turn(const Planar& a, const Planar& b, const Planar& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The corners, projected along the coordinate axis closest to the area vector (Newell's sum), such
// that the polygon runs counterclockwise.
std::vector<Planar> project(Points points, std::span<const VertexId> corners) {
  const Point& origin = points[corners[0].index()];
  Vec3 area;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area =
        area + cross(points[corners[i].index()] - origin, points[corners[i + 1].index()] - origin);
  }
  const double ax = std::abs(area.x);
  const double ay = std::abs(area.y);
  const double az = std::abs(area.z);
  std::vector<Planar> planar;
  planar.reserve(corners.size());
  for (VertexId v : corners) {
    const Vec3 p = points[v.index()] - origin;
    if (az >= ax && az >= ay) {
      planar.push_back(area.z >= 0 ? Planar{p.x, p.y} : Planar{p.y, p.x});
    } else if (ax >= ay) {
      planar.push_back(area.x >= 0 ? Planar{p.y, p.z} : Planar{p.z, p.y});
    } else {
      planar.push_back(area.y >= 0 ? Planar{p.z, p.x} : Planar{p.x, p.z});
    }
  }
  return planar;
}

bool is_convex(const std::vector<Planar>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < 0) return false;
  }
  return true;
}

void cut_fan(std::span<const VertexId> corners, const std::vector<std::size_t>& rest,
             std::vector<Triangle>& triangles) {
  for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
    triangles.push_back({corners[rest[0]], corners[rest[i]], corners[rest[i + 1]]});
  }
}

// Whether the triangle at rest[i] turns left and holds none of the other corners.
bool is_ear(const std::vector<Planar>& polygon, const std::vector<std::size_t>& rest,
            std::size_t i) {
  const std::size_t n = rest.size();
  const Planar& a = polygon[rest[(i + n - 1) % n]];
  const Planar& b = polygon[rest[i]];
  const Planar& c = polygon[rest[(i + 1) % n]];
  if (!(turn(a, b, c) > 0)) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const Planar& p = polygon[rest[(i + k) % n]];
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
  }
  return true;
}

}  // namespace

void triangulate_polygon(Points points, std::span<const VertexId> corners,
                         std::vector<Triangle>& triangles) {
  triangles.clear();
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const std::vector<Planar> polygon = project(points, corners);
  std::vector<std::size_t> rest;  // positions in `corners` that are not cut off yet
  for (std::size_t i = 0; i < corners.size(); ++i) rest.push_back(i);

  while (rest.size() > 3 && !(rest.size() == corners.size() && is_convex(polygon))) {
    std::size_t ear = 0;
    while (ear < rest.size() && !is_ear(polygon, rest, ear)) ++ear;
    if (ear == rest.size()) break;
    const std::size_t n = rest.size();
    triangles.push_back(
        {corners[rest[(ear + n - 1) % n]], corners[rest[ear]], corners[rest[(ear + 1) % n]]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  cut_fan(corners, rest, triangles);
}

}  // namespace cocoon
