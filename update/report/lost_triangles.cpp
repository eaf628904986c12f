#include "update/report/lost_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

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
    result.staying_area += area_of(model, t);
    if (triangle_map[t].is_none()) result.lost.push_back(t);
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

Point middle_of(const std::array<Point, 3>& corners) {
  const auto& [a, b, c] = corners;
  return a + (1.0 / 3) * ((b - a) + (c - a));
}

// Tells which places of the model are off the updated mesh though nothing was scanned there.
class AstrayPlaces {
 public:
  AstrayPlaces(const TriangleMesh& updated, std::span<const Scan> scans,
               const AstrayOptions& options)
      : tree_(updated), options_(options) {
    for (const Scan& scan : scans) {
      scanned_.add(scan.samples, options.reach * scan.spacing);
      spacing_ = std::max(spacing_, scan.spacing);
    }
  }

  // The share of the triangle's area that is astray. `longest`: its longest side.
  double share_of(const std::array<Point, 3>& corners, double longest) const {
    double limit = options_.tolerance * longest;
    if (spacing_ > 0) limit = std::min(limit, options_.most_spacings * spacing_);
    const auto is_off = [&](const Point& p) {
      return tree_.closest(p).squared_distance > limit * limit;
    };
    const Point middle = middle_of(corners);
    if (is_off(middle) && !scanned_.contain(middle)) return 1;
    const std::size_t parts = parts_of(longest);
    if (parts == 1) return 0;
    std::size_t astray = 0;
    for_each_middle(corners, parts, [&](const Point& place) {
      astray += !scanned_.surround(place) && is_off(place);
    });
    return static_cast<double>(astray) / static_cast<double>(parts * parts);
  }

 private:
  std::size_t parts_of(double longest) const {
    const double limit = options_.coarse_ratio * spacing_;
    if (!(limit > 0)) return 1;
    const double parts = std::ceil(longest / limit);
    return static_cast<std::size_t>(
        std::clamp(parts, 1.0, static_cast<double>(std::max<std::size_t>(options_.most_parts, 1))));
  }

  // Of the equal triangles into which `parts` parts of each side divide it.
  template <class Visit>
  static void for_each_middle(const std::array<Point, 3>& corners, std::size_t parts,
                              const Visit& visit) {
    const double step = 1.0 / (3 * static_cast<double>(parts));
    const auto visit_at = [&](std::size_t i, std::size_t j, std::size_t thirds) {
      const double u = static_cast<double>(3 * i + thirds) * step;
      const double v = static_cast<double>(3 * j + thirds) * step;
      visit(corners[0] + (u * (corners[1] - corners[0]) + v * (corners[2] - corners[0])));
    };
    for (std::size_t i = 0; i < parts; ++i) {
      for (std::size_t j = 0; i + j < parts; ++j) {
        visit_at(i, j, 1);
        if (i + j + 1 < parts) visit_at(i, j, 2);
      }
    }
  }

  ClosestFacetTree tree_;
  ScannedPlaces scanned_;
  AstrayOptions options_;
  double spacing_ = 0;  // the largest one
};

}  // namespace

AstrayTriangles astray_triangles(const TriangleMesh& model, std::span<const TriangleId> triangles,
                                 const TriangleMesh& updated, std::span<const Scan> scans,
                                 const AstrayOptions& options) {
  require_options("astray_triangles", options);
  const AstrayPlaces places(updated, scans, options);
  AstrayTriangles result;
  std::vector<Sized> found;
  double largest = 0;
  for (const TriangleId t : triangles) {
    const auto [a, b, c] = corners_of(model, t);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const double share = places.share_of({a, b, c}, longest);
    if (share == 0) continue;
    const double area = share * area_of(model, t);
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
