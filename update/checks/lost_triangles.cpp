#include "update/checks/lost_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geom/arrays/median.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/search/closest_facet.h"
#include "update/cloud/scanned_places.h"
#include "update/stage_options.h"

namespace cocoon {

LostTriangles lost_triangles(const TriangleMesh& model,
                             const IdVector<VertexId, PointId>& point_of_vertex,
                             const IdVector<TriangleId, TriangleId>& triangle_map) {
  LostTriangles result;
  for (const TriangleId t : model.triangles.ids()) {
    const Triangle& corners = model.triangles[t];
    const bool stays = std::none_of(corners.begin(), corners.end(),
                                    [&](VertexId v) { return point_of_vertex[v].is_none(); });
    if (!stays) continue;
    ++result.staying;
    const double area = area_of(model, t);
    result.staying_area += area;
    if (!triangle_map[t].is_none()) continue;
    result.lost.push_back(t);
    result.lost_area += area;
  }
  return result;
}

namespace {

// A triangle by its size.
struct Sized {
  double longest = 0;
  double area = 0;
};

// Half of the area is in triangles whose longest edge is at most this long.
double median_by_area(std::vector<Sized> triangles, double area) {
  std::sort(triangles.begin(), triangles.end(), [](const Sized& a, const Sized& b) {
    return a.longest != b.longest ? a.longest < b.longest : a.area < b.area;
  });
  double below = 0;
  for (const Sized& triangle : triangles) {
    below += triangle.area;
    if (below >= 0.5 * area) return triangle.longest;
  }
  return triangles.empty() ? 0 : triangles.back().longest;
}

// The diameter of a flat disk with the same median distance from the middle.
double extent_of(Points points) {
  if (points.empty()) return 0;
  const auto median_of = [&](auto number) {
    std::vector<double> numbers;
    for (const Point& p : points) numbers.push_back(number(p));
    return median(std::move(numbers));
  };
  const Point middle = {median_of([](const Point& p) { return p.x; }),
                        median_of([](const Point& p) { return p.y; }),
                        median_of([](const Point& p) { return p.z; })};
  return std::sqrt(8.0) * median_of([&](const Point& p) { return norm(p - middle); });
}

}  // namespace

double large_side(std::span<const Scan> scans, const AstrayOptions& options) {
  require_options("large_side", options);
  if (scans.empty()) return 0;
  double extent = std::numeric_limits<double>::infinity();
  for (const Scan& scan : scans) extent = std::min(extent, extent_of(scan.samples));
  return std::max(options.coarse_ratio * largest_spacing(scans), options.min_extent_share * extent);
}

AstrayTriangles astray_triangles(const TriangleMesh& model, std::span<const TriangleId> triangles,
                                 const TriangleMesh& updated, std::span<const Scan> scans,
                                 const AstrayOptions& options) {
  require_options("astray_triangles", options);
  const ClosestFacetTree tree(updated);
  ScannedPlaces scanned;
  for (const Scan& scan : scans) scanned.add(scan.samples, options.reach * scan.spacing);
  const double most = scans.empty() ? std::numeric_limits<double>::infinity()
                                    : options.most_spacings * largest_spacing(scans);
  AstrayTriangles result;
  std::vector<Sized> found;
  double largest = 0;
  for (const TriangleId t : triangles) {
    const auto [a, b, c] = corners_of(model, t);
    const double longest = longest_edge(model, t);
    const double limit = std::min(options.tolerance * longest, most);
    const Point middle = a + (1.0 / 3) * ((b - a) + (c - a));
    if (tree.is_within(middle, limit * limit)) continue;
    if (scanned.contain(middle)) continue;
    const double area = area_of(model, t);
    ++result.count;
    result.area += area;
    found.push_back({longest, area});
    if (area > largest) {
      largest = area;
      result.largest = t;
    }
  }
  result.median_longest_edge = median_by_area(std::move(found), result.area);
  return result;
}

}  // namespace cocoon
