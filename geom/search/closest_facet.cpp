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

}  // namespace

ClosestFacetTree::ClosestFacetTree(const TriangleMesh& mesh, const Execution& execution) {
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
}

ClosestFacet ClosestFacetTree::closest(const Point& p) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ClosestFacet best;
  best.squared_distance = infinity;
  const Corners* best_corners = nullptr;
  tree_.visit_near(p, infinity, [&](std::uint32_t slot) {
    const Corners& corners = corners_[slot];
    const ClosestPoint candidate = closest_point_on_triangle(p, corners.points);
    const double squared = candidate.squared_distance;
    const bool wins =
        squared < best.squared_distance || best_corners == nullptr ||
        (squared == best.squared_distance &&
         (corners.points != best_corners->points ? corners.points < best_corners->points
                                                 : corners.triangle < best_corners->triangle));
    if (wins) {
      best = {corners.triangle, candidate.point, squared};
      best_corners = &corners;
    }
    return slack_of_bound * best.squared_distance;
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

}  // namespace cocoon
