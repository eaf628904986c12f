// From where the 3D views of a report look at first.
#pragma once

#include <cstddef>
#include <span>

#include "geom/triangle_mesh.h"

namespace cocoon::app {

// A direction of the views' turntable, whose axis is z: the viewer stands at
// (cos e cos a, cos e sin a, sin e) as seen from the middle of the scene. The default looks a
// little down on the scene.
struct PageView {
  double azimuth_deg = -60;
  double elevation_deg = 28;
};

struct PageViewOptions {
  double enough = 0.5;
  std::size_t asked = 400;  // triangles, at most
};

// The direction, of a few around the turntable, to which the given triangles of `mesh` show most of
// their front: the sum of area times the cosine towards the viewer where that is positive and no
// other triangle lies before the middle. Of many triangles `asked`, evenly taken from the list,
// stand for all. The default direction stays if it shows at least `enough` of the most.
// Triangles counterclockwise as seen from outside. Errors: InputError as finite_corners_of.
// Complexity: O(t log t) for a mesh of t, and 48 rays for each that is asked.
PageView view_towards(const TriangleMesh& mesh, std::span<const TriangleId> triangles,
                      const PageViewOptions& options = {});

}  // namespace cocoon::app
