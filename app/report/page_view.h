// From where the 3D views of a report look at first.
#pragma once

#include <array>
#include <span>

#include "geom/point.h"

namespace cocoon::app {

// A direction of the views' turntable, whose axis is z: the viewer stands at
// (cos e cos a, cos e sin a, sin e) as seen from the middle of the scene. The default looks a
// little down on the scene.
struct PageView {
  double azimuth_deg = -60;
  double elevation_deg = 28;
};

// The direction, of a few around the turntable, to which the given triangles show most of their
// front: the sum of area times the cosine towards the viewer where that is positive. What lies
// before them is not asked. The default direction stays if it shows at least `enough` of the most.
// Triangles counterclockwise as seen from outside. Complexity: 48 directions a triangle.
struct PageViewOptions {
  double enough = 0.6;
};
PageView view_towards(std::span<const std::array<Point, 3>> triangles,
                      const PageViewOptions& options = {});

}  // namespace cocoon::app
