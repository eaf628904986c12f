#include "cocone/clean_up/far_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "cocone/facets/cell_order.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

double longest_edge(std::span<const Point> corners) {
  double longest = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      longest = std::max(longest, distance(corners[i], corners[k]));
    }
  }
  return longest;
}

}  // namespace

FarReach::FarReach(const Triangulation& triangulation, StarCache& stars, SpacingCache& spacings,
                   const CellMarks& marks, const CleanUpOptions& options,
                   const IdVector<CellId, std::uint8_t>& out)
    : triangulation_(triangulation),
      stars_(stars),
      spacings_(spacings),
      marks_(marks),
      near_surface_(options.near_surface),
      stretch_ratio_(options.stretch_ratio),
      out_(out) {}

bool FarReach::is_near_surface(VertexId v) {
  if (near_surface_ == 0) return false;
  for (const CellId c : stars_.star(v)) {
    if (triangulation_.is_infinite(c)) continue;
    const int opposite = index_of_vertex(triangulation_.cell(c), v);
    if (out_[c] == out_[triangulation_.neighbor(c, opposite)]) continue;
    if (is_near_facet(v, facet_id(c, opposite))) return true;
  }
  return false;
}

// Corners in lexicographic order: the same bits wherever they are numbered.
bool FarReach::is_near_facet(VertexId v, FacetId f) {
  const double spacing = spacings_.of(v);
  const std::array<Point, 3> corners = sorted_corners(triangulation_, f);
  if (longest_edge(corners) > stretch_ratio_ * spacing) return false;
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double volume = std::abs(dot(normal, triangulation_.point(v) - corners[0]));
  return volume <= near_surface_ * spacing * norm(normal);
}

bool FarReach::reaches_far(CellId c, VertexId v) {
  if (marks_.labels[c] == CellLabel::unmarked) return false;
  return longest_edge(sorted_corners(triangulation_, c)) > stretch_ratio_ * spacings_.of(v);
}

}  // namespace cocoon
