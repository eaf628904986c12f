#include "geom/closest_facet.h"

#include <algorithm>
#include <limits>

#include "geom/errors.h"
#include "geom/triangle_projection.h"

namespace cocoon {
namespace {

// A computed closest point may lie outside its triangle by rounding, so that the computed distance
// is less than that of the triangle's box. Boxes are enlarged by this fraction of the largest
// coordinate: a few hundred times the rounding of one addition.
constexpr double slack_per_coordinate = 0x1p-44;

}  // namespace

ClosestFacetTree::ClosestFacetTree(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw InputError("mesh has no triangles, so that none is closest; give a surface");
  }
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  Box whole;
  for (const TriangleId t : mesh.triangles.ids()) {
    boxes.push_back(box_of(finite_corners_of(mesh, t)));
    whole.include(boxes.back());
  }
  const double slack = slack_per_coordinate * std::max(max_norm(whole.low), max_norm(whole.high));
  for (Box& box : boxes) box.enlarge(slack);
  tree_ = BoxTree(boxes);
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
    return best.squared_distance;
  });
  return best;
}

}  // namespace cocoon
