// The plainly right twin of ClosestFacetTree::closest: looks at every triangle.
#pragma once

#include "geom/point.h"
#include "geom/search/closest_facet.h"
#include "geom/triangle_mesh.h"

namespace cocoon::ref {

// The triangle of `mesh` closest to p, with the same rule for ties. The closest point of each
// triangle is found in its own way: the projection if it falls inside, else the nearest of the
// points closest on the three edges. Distances agree with the tree's up to rounding.
// Throws InputError for a mesh without triangles. Complexity: O(t).
ClosestFacet brute_force_closest_facet(const TriangleMesh& mesh, const Point& p);

}  // namespace cocoon::ref
