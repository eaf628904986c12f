// How the ids of a changing triangulation change when its gaps are closed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/ids.h"

namespace cocoon {

// Two places whose records have changed places: `b` held a live cell, `a` any.
struct CellExchange {
  CellId a, b;
};

// Whoever keeps arrays by slot follows: elements of cells change places, one exchange after the
// other, those of vertices move, each to a slot that was not in use; then the arrays end with the
// last slot in use.
struct Renumbering {
  struct Move {
    VertexId from, to;
  };
  std::vector<CellExchange> cells;
  std::vector<Move> vertices;  // `from` increasing
};

// Replaces ids of vertices that have moved; of several moves from one slot the last counts.
// `slots`: ids before were below. Complexity: O(slots + vertices), O(1) if none has moved.
void rename_vertices(std::span<const Renumbering::Move> moves, std::size_t slots,
                     std::span<VertexId> vertices);

}  // namespace cocoon
