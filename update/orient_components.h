// The edge-connected parts of an open surface, each oriented consistently.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct SurfaceComponents {
  // The component of each triangle, numbered by its first triangle.
  IdVector<TriangleId, std::uint32_t> component_of;
  std::vector<std::size_t> triangles;  // per component
  // Edges at which the orientation could not be made to agree: more than 0 means that a component
  // is one-sided, like a Moebius strip.
  std::size_t conflicts = 0;
};

// Turns triangles of `surface` around so that any two that share an edge with no third one run
// through it in opposite directions. The first triangle of each component keeps its orientation.
// Only corners are exchanged; triangles keep their ids. Complexity: O(triangles + vertices).
// Deterministic: breadth first from the lowest triangle id.
// Source: Woo & Dey 2005, section 3.2 leaves the orientation of the open Cocone surface open;
// boundary loops and rim normals need one.
SurfaceComponents orient_components(TriangleMesh& surface);

}  // namespace cocoon
