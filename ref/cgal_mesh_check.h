// What CGAL says about a mesh: the oracle of mesh_check, mesh_measure and self_intersection.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::ref {

// The measures of a mesh that CGAL can represent.
struct CgalMeshMeasure {
  bool closed = false;
  double area = 0;
  double volume = 0;           // of a closed mesh, else 0
  std::size_t components = 0;  // connected by edges
  std::size_t boundary_cycles = 0;
  std::size_t self_intersections = 0;  // pairs of triangles
};

// Nothing if the mesh is not an oriented 2-manifold (with or without boundary): a directed edge is
// used twice, an edge has more than two triangles, a vertex is pinched or repeated in a triangle.
// Source: CGAL 5.5, Polygon Mesh Processing. Complexity: O(t log t).
std::optional<CgalMeshMeasure> cgal_mesh_check(const TriangleMesh& mesh);

// Do the triangles meet in more than their shared corners (see geom/self_intersection.h)? Decided
// by constructing their intersection in exact arithmetic and comparing it with what they share.
// Neither triangle may have its corners on one line. Complexity: O(1), slow.
bool cgal_triangles_intersect(const std::array<Point, 3>& a, const std::array<Point, 3>& b);

}  // namespace cocoon::ref
