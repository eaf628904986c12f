// CGAL's answer to on which side of a closed mesh points lie, and how far from it.
#pragma once

#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::rivals {

// As signed_distances(): negative inside. Side_of_triangle_mesh, and the AABB tree that it can
// share; both built here. Precondition: the mesh is closed and a manifold.
std::vector<double> cgal_signed_distances(const TriangleMesh& mesh, Points points);

}  // namespace cocoon::rivals
