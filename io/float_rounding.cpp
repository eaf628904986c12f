#include "io/float_rounding.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/search/point_welder.h"

namespace cocoon {

namespace {

Point rounded(const Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Each once.
std::vector<Point> corners_of(const TriangleMesh& mesh) {
  std::vector<bool> seen(mesh.points.size(), false);
  std::vector<Point> corners;
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId v : triangle) {
      if (seen[v.index()]) continue;
      seen[v.index()] = true;
      corners.push_back(mesh.points[v]);
    }
  }
  return corners;
}

std::size_t count_places(const std::vector<Point>& points) {
  std::vector<Point> places;
  PointWelder welder(places);
  for (const Point& p : points) welder.add(p);
  return places.size();
}

// Also where squares are too small for doubles.
double length(const Point& a, const Point& b) {
  constexpr double safe = 1e-140;
  const double d = distance(a, b);
  return d > safe ? d : std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

double median_side(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      lengths.push_back(length(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]));
    }
  }
  return median(std::move(lengths));
}

}  // namespace

FloatRounding float_rounding(const TriangleMesh& mesh) {
  FloatRounding result;
  const std::vector<Point> corners = corners_of(mesh);
  std::vector<Point> moved;
  moved.reserve(corners.size());
  for (const Point& p : corners) {
    moved.push_back(rounded(p));
    result.largest_move = std::max(result.largest_move, length(p, moved.back()));
  }
  if (moved == corners) return result;
  const std::size_t places = count_places(moved);
  if (places < corners.size()) result.merged_vertices = count_places(corners) - places;
  result.median_edge = median_side(mesh);
  return result;
}

}  // namespace cocoon
