// Sizes of a mesh: area, volume, box, edge lengths.
#pragma once

#include <cstddef>

#include "geom/box.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Lengths of the edges, each edge once. All zero for no edges. The median and the deciles are
// lengths that occur: of n sorted lengths those at positions n/2, n/10 and 9n/10, rounded down.
struct EdgeLengths {
  std::size_t count = 0;
  double min = 0;
  double first_decile = 0;
  double median = 0;
  double last_decile = 0;
  double max = 0;
  double mean = 0;

  friend bool operator==(const EdgeLengths&, const EdgeLengths&) = default;
};

struct MeshMeasure {
  double area = 0;
  double signed_volume = 0;  // positive for a closed surface oriented outward
  Box box;                   // of the corners of triangles; empty for no triangles
  EdgeLengths edge_lengths;

  friend bool operator==(const MeshMeasure&, const MeshMeasure&) = default;
};

// Signed volume of the tetrahedron between a triangle and the apex: positive if it faces away from
// there. O(1).
inline double volume_over(const TriangleMesh& mesh, TriangleId t, const Point& apex) {
  const auto [a, b, c] = corners_of(mesh, t);
  return dot(a - apex, cross(b - apex, c - apex)) / 6;
}

// Measures `mesh`, whose triangles must name vertices that are there and finite (else InputError).
// The volume is the sum of the tetrahedra between each triangle and the center of the box: for a
// surface that is not closed it depends on that center. Sums are compensated, so that they are
// right to about the rounding of one addition (relative to the area, for narrow triangles to the
// squares of their longest edges; or to area times box size). Coordinates may have any size; a
// figure beyond the range of double is infinite or 0.
// Complexity: O(t log t). Deterministic: sums run in the order of triangles and edges.
// Source of the summation: Neumaier 1974.
MeshMeasure mesh_measure(const TriangleMesh& mesh);

}  // namespace cocoon
