// Consistent orientation of an open surface.
#pragma once

#include <cstddef>

#include "geom/mesh/edge_components.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct OrientationReport {
  std::size_t flipped = 0;  // triangles turned around
  // Components, connected through edges with exactly two triangles, that were left as they were:
  // one-sided, like a Moebius strip.
  std::size_t non_orientable = 0;
};

// Turns triangles around (corners two and three change places, ids stay) until any two that share
// an edge with no third one run through it in opposite directions. Of the two consistent ways each
// component takes the one that turns fewer triangles, in a tie the one that keeps the triangle with
// the smallest circle (facet_size.h, ties by the corners). Independent of the numbering of the
// mesh. Errors: InputError as link_halfedges(). Complexity: O(triangles + vertices).
OrientationReport orient_surface(TriangleMesh& mesh);

// Overload for callers that already have the components of the mesh (InputError, by their sizes,
// for those of another one). The links of its halfedges stay valid unless triangles are flipped.
OrientationReport orient_surface(TriangleMesh& mesh, const EdgeComponents& components);

}  // namespace cocoon
