// Edges of a mesh at which it is not smooth.
#pragma once

#include <vector>

#include "geom/mesh/halfedges.h"
#include "geom/mesh/linked_mesh.h"

namespace cocoon {

// The cosine of 15 degrees: CAD programs approximate round faces by facets that differ by less.
inline constexpr double default_smooth_cosine = 0.96592582628906829;

// The first halfedge of each edge whose two triangles have normals with a smaller cosine than this,
// or which does not have two triangles; increasing. An edge at a triangle without area is not
// sharp. Precondition: coordinates of working size (working_scale.h). Complexity: O(triangles +
// s log s) for s such edges.
std::vector<Halfedge> sharp_edges(const LinkedMesh& mesh,
                                  double smooth_cosine = default_smooth_cosine);

}  // namespace cocoon
