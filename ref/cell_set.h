// Triangulations compared as sets, whatever their numbering.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "delaunay/triangulation.h"

namespace cocoon::ref {

// The finite cells, each by the input points at its vertices (of equal points the first) in
// increasing order; sorted. Two triangulations of the same input have the same cells iff these
// are equal. Complexity: O(cells log cells).
std::vector<std::array<PointId, 4>> cell_set(const Triangulation& triangulation);

// A hash of cell_set that needs no sorting: sums a mix of each cell. Equal sets, equal hashes;
// different sets differ but for an accident of 2^-64. Complexity: O(cells).
std::uint64_t cell_set_hash(const Triangulation& triangulation);

// The share of one cell in cell_set_hash, for rivals that have their own data structures.
std::uint64_t cell_hash(std::array<PointId, 4> cell);

}  // namespace cocoon::ref
