// Models from elsewhere: turned so that they face outward, as an update presumes.
#pragma once

#include <cstddef>

#include "geom/triangle_mesh.h"

namespace cocoon {

struct OrientOutwardOptions {
  // A part with open edges counts as a body if the square of their length is below this share of
  // its area: then what is missing hardly matters for its volume. A sphere with a hole may lack a
  // seventh of its area at 1.
  double max_opening = 1;
};

struct OutwardReport {
  std::size_t turned = 0;     // triangles
  std::size_t one_sided = 0;  // parts left as they were: like a Moebius strip
};

// Turns triangles around (corners two and three change places, ids stay) until
//   1. any two that share an edge with no third one run through it in opposite directions: of each
//      part, connected by such edges, fewer are turned (orient_surface());
//   2. bodies whose triangles were at odds have a positive volume;
//   3. the volumes of all bodies sum up to a positive one: else those whose triangles agreed are
//      turned as a whole. So hollows within a body stay what they are.
// Open sheets have no outside: their triangles agree, but which side they show stays. The volume of
// an open body is that of the cone from the mean of its open edges.
// Errors: InputError as link_halfedges(), and unless max_opening is 0 or more. Complexity:
// O(triangles + vertices). A mesh that faces outward stays as it is, to the bit.
// Source: ours; Woo & Dey 2005 start with meshes of their own.
OutwardReport orient_outward(TriangleMesh& mesh, const OrientOutwardOptions& options = {});

}  // namespace cocoon
