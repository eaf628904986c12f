// The errors of a real scan, added to an ideal one: noise of the sensor, and registration that is
// somewhat off.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/point.h"

namespace cocoon::ref {

struct ScanErrors {
  // Each point is moved in a random direction, by a random distance of up to `noise`.
  double noise = 0;
  // The cloud is turned about its center and shifted, both at random, so that the point that moves
  // farthest moves by `registration`.
  double registration = 0;
  std::uint64_t seed = 1;
};

// Both in units of the coordinates. Throws InputError if one is negative or not finite.
// Complexity: O(n). Deterministic.
void add_scan_errors(std::vector<Point>& cloud, const ScanErrors& errors);

}  // namespace cocoon::ref
