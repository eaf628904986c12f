// A triangle mesh of the surface of an implicit solid.
#pragma once

#include "geom/triangle_mesh.h"
#include "io/models/implicit_solid.h"

namespace cocoon {

// Cuts the solid's box into cubes of side `cell`, each into six tetrahedra, and takes from each
// tetrahedron the one or two triangles that separate its corners inside from those outside; then
// moves the vertices to the surface. The result is a closed 2-manifold, oriented outward, whatever
// the function (neighboring tetrahedra agree on their common face), as long as the solid does not
// reach the border of its box. Features thinner than a cell may be lost, and so may parts of a
// surface across which the function changes faster than twice the distance.
// Throws InputError for a cell that is not positive, or so small that there are more than 2^31
// grid points, and if the solid reaches the border of its box.
// Complexity: (box / cell)^3 steps; calls of the function near the surface, one in 64 elsewhere.
// Deterministic.
// Source: Doi & Koide 1991; the subdivision into tetrahedra is that of Kuhn 1960.
TriangleMesh polygonize(const ImplicitSolid& solid, double cell);

}  // namespace cocoon
