// What a mesh loses in a file whose coordinates are floats.
#pragma once

#include <cstddef>

#include "geom/triangle_mesh.h"

namespace cocoon {

struct FloatRounding {
  // Corners of triangles that come to the place of others, from which they were apart before.
  std::size_t merged_vertices = 0;
  double largest_move = 0;  // of a corner of a triangle
  double median_edge = 0;   // of the sides of the triangles as given; 0 if nothing moves

  // Whether the file may well be another surface than the mesh: closed and manifold no longer, or
  // crossing itself. Below this share of an edge, moves change angles by few degrees.
  static constexpr double noticeable_move_share = 0.05;
  bool is_noticeable() const {
    return merged_vertices > 0 || largest_move > noticeable_move_share * median_edge;
  }
};

// What rounding to the nearest floats does. Far from the origin they are far apart: 0.5 at 5e6.
// Precondition: the coordinates of corners are in the range of float. Complexity: O(triangles) if
// no corner moves, else expected.
FloatRounding float_rounding(const TriangleMesh& mesh);

}  // namespace cocoon
