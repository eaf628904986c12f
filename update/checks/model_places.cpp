#include "update/checks/model_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geom/mesh/triangles_by_area.h"
#include "geom/search/closest_facet.h"
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

UnscannedPlaces::UnscannedPlaces(std::span<const Scan> scans, const AstrayOptions& options)
    : options_(options), spacing_(largest_spacing(scans)) {
  require_options("UnscannedPlaces", options);
  for (const Scan& scan : scans) scanned_.add(scan.samples, options.reach * scan.spacing);
}

std::vector<ModelPlace> UnscannedPlaces::of(const TriangleMesh& mesh,
                                            std::span<const TriangleId> triangles) const {
  std::vector<ModelPlace> places;
  for (const TriangleId t : triangles) append(mesh, t, places);
  return places;
}

std::vector<ModelPlace> UnscannedPlaces::of(const TriangleMesh& mesh) const {
  std::vector<ModelPlace> places;
  for (const TriangleId t : mesh.triangles.ids()) append(mesh, t, places);
  return places;
}

void UnscannedPlaces::append(const TriangleMesh& mesh, TriangleId t,
                             std::vector<ModelPlace>& places) const {
  const double area = area_of(mesh, t);
  if (!(area > 0) || !(spacing_ > 0)) return;
  const std::size_t parts =
      parts_of(longest_edge(mesh, t), options_.coarse_ratio * spacing_, options_.most_parts);
  const double of_part = area / static_cast<double>(parts * parts);
  for_each_middle(corners_of(mesh, t), parts, [&](const Point& middle) {
    if (!scanned_.contain(middle)) places.push_back({middle, of_part});
  });
}

std::vector<std::uint8_t> UnscannedPlaces::are_off(std::span<const ModelPlace> places,
                                                   const TriangleMesh& mesh) const {
  if (places.empty()) return {};
  const ClosestFacetTree tree(mesh);
  std::vector<std::uint8_t> off;
  off.reserve(places.size());
  for (const ModelPlace& place : places) {
    off.push_back(tree.is_within(place.at, reach() * reach()) ? 0 : 1);
  }
  return off;
}

double UnscannedPlaces::area_off(std::span<const ModelPlace> places,
                                 const TriangleMesh& mesh) const {
  const std::vector<std::uint8_t> off = are_off(places, mesh);
  double area = 0;
  for (std::size_t k = 0; k < places.size(); ++k) area += off[k] != 0 ? places[k].area : 0;
  return area;
}

}  // namespace cocoon
