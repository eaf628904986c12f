// Orders in which points are stored and inserted, so that neighbors in space are near in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// The points' ids sorted along a Hilbert curve through the bounding cube of the set; points in
// the same cell of the curve's finest level are sorted by a finer curve of their own, and in the
// end lexicographically by coordinates. The resulting sequence of coordinates is a function of the
// point set alone; equal points are neighbors in it, in increasing order of id.
// Precondition: all coordinates finite.
// Complexity: O(n) (radix sort), plus O(k log k) for groups of k points that share a curve cell;
// divided by the threads, but for one such group.
// Source: Hamilton & Rau-Chaplin, Compact Hilbert indices (2008), for the state of the curve.
std::vector<PointId> hilbert_order(Points points, const Execution& execution = {});

// A cheap order for the same end: the points' ids grouped by the cells of a cubic grid of 64^3
// along the curve, increasing within a cell; points with a coordinate that is not finite come last.
// Complexity: O(n): one pass for the cells, one counting sort. Deterministic.
std::vector<PointId> rough_order(Points points, const Execution& execution = {});

struct InsertionRounds {
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> ends;  // of the rounds, as positions in `order`
};

// A biased randomized insertion order of [0, count): rounds of geometrically growing size, each
// element in a round drawn by a hash of (seed, element). The last round is in increasing order of
// elements, the one before in decreasing order, and so on in turn, so that a round starts near
// where the one before ended. Inserting points that are numbered along a space-filling curve in
// this order keeps point location short and memory accesses local, while the expected total work
// stays that of a random order. The same for every number of threads. Complexity: O(n). Source:
// Amenta, Choi & Rote, Incremental constructions con BRIO (SoCG 2003).
InsertionRounds insertion_rounds(std::size_t count, std::uint64_t seed,
                                 const Execution& execution = {});

}  // namespace cocoon
