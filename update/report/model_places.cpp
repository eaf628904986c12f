#include "update/report/model_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geom/mesh/triangles_by_area.h"
#include "geom/search/closest_facet.h"
#include "update/cloud/scanned_places.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Calls visit(place) for the middles of the equal triangles into which `parts` parts of each side
// divide the triangle.
template <class Visit>
void for_each_middle(const std::array<Point, 3>& corners, std::size_t parts, const Visit& visit) {
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

// None of them longer than `limit` if possible.
std::size_t parts_of(double longest, double limit, std::size_t most) {
  if (!(longest > limit)) return 1;
  const double parts = std::ceil(longest / limit);
  return static_cast<std::size_t>(std::clamp(parts, 1.0, static_cast<double>(most)));
}

}  // namespace

std::vector<ModelPlace> unscanned_places(const TriangleMesh& model,
                                         std::span<const TriangleId> triangles,
                                         std::span<const Scan> scans,
                                         const AstrayOptions& options) {
  require_options("unscanned_places", options);
  ScannedPlaces scanned;
  double spacing = 0;
  for (const Scan& scan : scans) {
    scanned.add(scan.samples, options.reach * scan.spacing);
    spacing = std::max(spacing, scan.spacing);
  }
  const double large = options.coarse_ratio * spacing;
  std::vector<ModelPlace> places;
  if (!(spacing > 0)) return places;
  for (const TriangleId t : triangles) {
    const auto [a, b, c] = corners_of(model, t);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const double area = area_of(model, t);
    if (!(area > 0)) continue;
    ModelPlace place{{}, t, area, options.most_spacings * spacing, longest > large};
    const std::size_t parts = parts_of(longest, large, options.most_parts);
    place.area /= static_cast<double>(parts * parts);
    for_each_middle({a, b, c}, parts, [&](const Point& middle) {
      if (scanned.contain(middle)) return;
      place.at = middle;
      places.push_back(place);
    });
  }
  return places;
}

std::vector<std::uint8_t> are_off(std::span<const ModelPlace> places, const TriangleMesh& updated) {
  const ClosestFacetTree tree(updated);
  std::vector<std::uint8_t> off;
  off.reserve(places.size());
  for (const ModelPlace& place : places) {
    off.push_back(tree.squared_distance(place.at) > place.reach * place.reach ? 1 : 0);
  }
  return off;
}

}  // namespace cocoon
