// Circumcenters of many tetrahedra at once, by the vector instructions of the processor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cocoon {

inline constexpr std::size_t circumcenter_batch_size = 8;

// Coordinates [axis][tetrahedron].
using BatchOfPoints = std::array<std::array<double, circumcenter_batch_size>, 3>;

struct CircumcenterBatch {
  alignas(64) std::array<BatchOfPoints, 4> corners;
  // Of those that are certified, circumcenter(a, b, c, d) bit for bit; else unspecified.
  alignas(64) BatchOfPoints centers;
  std::uint32_t certified;  // bit i: the center of tetrahedron i is
};

// Fills in the centers at level `doubles` of geom/circumsphere.h: same expressions, same bits,
// whatever the instruction set. What is not certified is left to circumcenter(): all that it would
// not certify, and a few more at the border. Many batches at a time, so that the processor begins
// the next one while the divisions of one are under way. Complexity: O(batches).
void circumcenters_in_doubles(std::span<CircumcenterBatch> batches);

}  // namespace cocoon
