// Triangulations compared as sets of cells by the places of their corners: where points come and
// go, their numbers mean nothing.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "delaunay/triangulation.h"
#include "geom/random/random.h"

namespace cocoon::bench {

// The share of one cell; the order of its corners does not count.
inline std::uint64_t place_hash(const std::array<Point, 4>& corners) {
  std::uint64_t sum = 0;
  for (const Point& p : corners) {
    std::uint64_t mixed = 0;
    for (const double x : {p.x, p.y, p.z}) {
      std::uint64_t state = mixed ^ std::bit_cast<std::uint64_t>(x + 0.0);  // -0 is 0
      mixed = splitmix64(state);
    }
    sum += mixed;
  }
  return splitmix64(sum);
}

// Equal sets of finite cells, equal hashes; different sets differ but for an accident of 2^-64.
// Complexity: O(cells).
inline std::uint64_t place_set_hash(const Triangulation& triangulation) {
  std::uint64_t sum = 0;
  for (const CellId c : triangulation.finite_cells()) {
    std::array<Point, 4> corners;
    for (int i = 0; i < 4; ++i) {
      corners[static_cast<std::size_t>(i)] = triangulation.point(triangulation.vertex(c, i));
    }
    sum += place_hash(corners);
  }
  return sum;
}

}  // namespace cocoon::bench
