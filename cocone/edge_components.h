// The parts of a surface that hang together by edges, and how their triangles are turned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/id_vector.h"
#include "geom/linked_sides.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct EdgeComponent {
  std::size_t triangles = 0;
  std::size_t turned = 0;         // of them, see below
  bool is_contradictory = false;  // no way to turn them that agrees everywhere: one-sided
};

struct EdgeComponents {
  std::vector<EdgeComponent> components;
  IdVector<TriangleId, std::uint32_t> component_of;
  // Whether the triangle runs against the first one of its component. Without meaning where that is
  // contradictory.
  IdVector<TriangleId, std::uint8_t> turned;
};

// Triangles are connected across edges with exactly two of them, and agree if they run through
// these in opposite directions. Components are in the order of their first triangles.
// Complexity: O(triangles).
EdgeComponents edge_components(const TriangleMesh& mesh, const LinkedSides& sides);

}  // namespace cocoon
