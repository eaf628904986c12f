// How often a closed mesh winds around a point, exactly: 0 outside.
#pragma once

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/search/triangle_tree.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Keeps its own copy of the triangles' corners, so that the mesh may go.
class WindingNumbers {
 public:
  // `mesh` is balanced (mesh_check.h): each edge is run through equally often in both directions.
  // Triangles without area, in whatever position, change nothing.
  // Throws InputError if a triangle names a vertex that is not there or has a coordinate that is
  // not finite. Complexity: O(t log t), parallel.
  explicit WindingNumbers(const TriangleMesh& mesh, const Execution& execution = {});

  // Of a mesh oriented outward: 1 inside, 0 outside; more where parts overlap, -1 inside of one
  // oriented inward. On the surface itself: that of one of its sides.
  // Exact: a ray along the x axis is followed; where it meets edges or vertices it is shifted by an
  // infinitesimal (e, e^2) in y and z. Precondition: finite coordinates.
  // Complexity: O(log t + triangles whose boxes the ray meets). Thread-safe.
  // Source of the shift: Edelsbrunner & Mücke, Simulation of simplicity (ACM TOG 9, 1990).
  int at(const Point& p) const;

 private:
  TriangleTree tree_;
};

}  // namespace cocoon
