// Handles of what samples have put into an updated surface.
#pragma once

#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// The handles of the triangles with a vertex from `first_new` on, taken alone: of each the length
// of a short closed path of edges around or through it (narrow_handles), ascending. So a handle
// that goes through the rest of the model is none of them, as a bore whose mouths are in it.
// `triangles`: with all of that kind, of a surface without open edges; `vertices`: their points.
// Where triangles touch at an edge or a vertex they are parted first (split_nonmanifold), and
// openings are closed by a vertex far away.
// Complexity: O(t) for t triangles, and O(n log n) for n with such a vertex. Errors: InputError if
// one of these has a vertex that is not there or not finite, or has one twice. Source: ours.
std::vector<double> patch_handles(Points vertices, std::span<const Triangle> triangles,
                                  VertexId first_new);

}  // namespace cocoon
