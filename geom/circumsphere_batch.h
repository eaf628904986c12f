// Circumcenters of many tetrahedra at once, by the vector instructions of the processor.
#pragma once

#include <array>
#include <cstddef>

#include "geom/point.h"

namespace cocoon {

inline constexpr std::size_t circumcenter_batch_size = 8;

struct CircumcenterBatch {
  // Coordinates [corner][axis][tetrahedron].
  alignas(64) std::array<std::array<std::array<double, circumcenter_batch_size>, 3>, 4> corners;
  // Of those that are certified, circumcenter(a, b, c, d) bit for bit; else unspecified.
  std::array<Point, circumcenter_batch_size> centers;
};

// Fills in the centers at level `doubles` of geom/circumsphere.h: same expressions, same bounds,
// whatever the instruction set. Bit i of the result: the center of tetrahedron i is certified; the
// others are left to circumcenter(). Complexity: O(1).
unsigned circumcenters_in_doubles(CircumcenterBatch& batch);

}  // namespace cocoon
