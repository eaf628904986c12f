#include "geom/search/closest_facet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/errors.h"
#include "geom/triangle_projection.h"

namespace cocoon {
namespace {

// A computed closest point may lie outside its triangle by rounding, so that the computed distance
// is less than that of the triangle's box. Boxes are enlarged by this fraction of their own largest
// coordinate: a few hundred times the rounding of one addition. Not of the mesh's, since one corner
// far out would enlarge all of them beyond their distances.
constexpr double slack_per_coordinate = 0x1p-44;

// The same of the distance itself, squared, where ties count.
constexpr double slack_of_bound = 1 + 0x1p-48;

// To compute a bound takes as long as a few queries save.
constexpr std::size_t queries_per_bound = 8;

}  // namespace

ClosestFacetTree::ClosestFacetTree(const TriangleMesh& mesh, const Execution& execution,
                                   std::size_t queries) {
  if (mesh.triangles.empty()) {
    throw InputError("mesh has no triangles, so that none is closest; give a surface");
  }
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    Box box = box_of(finite_corners_of(mesh, t));
    box.enlarge(slack_per_coordinate * std::max(max_norm(box.low), max_norm(box.high)));
    boxes.push_back(box);
  }
  tree_ = BoxTree(boxes, execution);
  corners_.reserve(boxes.size());
  for (const std::uint32_t item : tree_.items()) {
    corners_.push_back({sorted_corners(corners_of(mesh, TriangleId(item))), TriangleId(item)});
  }
  if (queries / queries_per_bound < corners_.size()) return;
  bounds_.reserve(corners_.size());
  for (const Corners& corners : corners_) bounds_.emplace_back(corners.points);
}

ClosestFacet ClosestFacetTree::closest(const Point& p) const {
  std::uint32_t slot = 0;
  return closest(p, slot);
}

ClosestFacet ClosestFacetTree::closest(const Point& p, std::uint32_t& slot) const {
  const auto on = [&](const Corners& corners) {
    const ClosestPoint foot = closest_point_on_triangle(p, corners.points);
    return ClosestFacet{corners.triangle, foot.point, foot.squared_distance};
  };
  const std::uint32_t begin = slot;
  ClosestFacet best = on(corners_[begin]);
  double limit = slack_of_bound * best.squared_distance;
  const double largest = max_norm(p);
  tree_.visit_near(p, limit, [&](std::uint32_t other) {
    if (other == begin) return limit;
    if (!bounds_.empty() && bounds_[other].squared_distance(p, largest) > limit) return limit;
    const Corners& corners = corners_[other];
    const ClosestFacet facet = on(corners);
    if (facet.squared_distance > best.squared_distance) return limit;
    const Corners& of_best = corners_[slot];
    const bool wins = facet.squared_distance < best.squared_distance ||
                      (corners.points != of_best.points ? corners.points < of_best.points
                                                        : corners.triangle < of_best.triangle);
    if (wins) {
      best = facet;
      slot = other;
      limit = slack_of_bound * best.squared_distance;
    }
    return limit;
  });
  return best;
}

double ClosestFacetTree::squared_distance(const Point& p) const {
  double best = std::numeric_limits<double>::infinity();
  double bound = best;
  tree_.visit_near(p, bound, [&](std::uint32_t slot) {
    const double squared = closest_point_on_triangle(p, corners_[slot].points).squared_distance;
    if (squared < best) {
      best = squared;
      bound = std::nextafter(best, -1.0);  // what is as far does not count
    }
    return bound;
  });
  return best;
}

bool ClosestFacetTree::is_within(const Point& p, double squared_reach) const {
  constexpr double nothing = -1;  // no box is as near
  double bound = slack_of_bound * squared_reach;
  tree_.visit_near(p, bound, [&](std::uint32_t slot) {
    if (bound == nothing) return bound;
    const double squared = closest_point_on_triangle(p, corners_[slot].points).squared_distance;
    if (squared <= squared_reach) bound = nothing;
    return bound;
  });
  return bound == nothing;
}

}  // namespace cocoon
