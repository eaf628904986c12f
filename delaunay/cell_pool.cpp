#include "delaunay/cell_pool.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

constexpr std::size_t grain = std::size_t{1} << 14;

// The cells that are not finite, in increasing order.
struct Exceptions {
  std::vector<CellId> infinite;
  std::vector<CellId> free;
};

Exceptions exceptions_of(const CellPool& pool, const Execution& execution) {
  std::vector<Exceptions> parts((pool.cells.size() + grain - 1) / grain);
  parallel_chunks(execution, pool.cells.size(), grain, [&](std::size_t begin, std::size_t end) {
    Exceptions& part = parts[begin / grain];
    for (std::size_t c = begin; c < end; ++c) {
      if (pool.is_free(CellId(c))) {
        part.free.push_back(CellId(c));
      } else if (pool.is_infinite(CellId(c))) {
        part.infinite.push_back(CellId(c));
      }
    }
  });
  Exceptions all;
  for (const Exceptions& part : parts) {
    all.infinite.insert(all.infinite.end(), part.infinite.begin(), part.infinite.end());
    all.free.insert(all.free.end(), part.free.begin(), part.free.end());
  }
  return all;
}

// A cell that is to go to a place that is free, or from which another one goes.
struct Move {
  CellId from, to;
};

// What must move for `finite` finite cells to come first and the infinite ones next, nothing free
// between them.
std::vector<Move> moves_into_order(const CellPool& pool, const Exceptions& exceptions,
                                   std::size_t finite) {
  const std::size_t live = finite + exceptions.infinite.size();
  // Finite cells behind their part go where there is none, infinite ones likewise.
  std::vector<CellId> holes;
  for (const std::vector<CellId>* list : {&exceptions.infinite, &exceptions.free}) {
    holes.insert(holes.end(), list->begin(),
                 std::lower_bound(list->begin(), list->end(), CellId(finite)));
  }
  std::sort(holes.begin(), holes.end());
  std::vector<Move> moves;
  std::vector<CellId> infinite_holes;
  for (std::size_t c = finite; c < pool.cells.size(); ++c) {
    const CellId here(c);
    const bool is_free = pool.is_free(here);
    const bool is_infinite = !is_free && pool.is_infinite(here);
    if (!is_free && !is_infinite) moves.push_back({here, holes[moves.size()]});
    if (!is_infinite && c < live) infinite_holes.push_back(here);
  }
  auto next_hole = infinite_holes.begin();
  for (const CellId c : exceptions.infinite) {
    if (c.index() < finite || c.index() >= live) moves.push_back({c, *next_hole++});
  }
  return moves;
}

void move_cells(CellPool& pool, std::span<const Move> moves, const Execution& execution) {
  std::vector<Cell> records(moves.size());
  const auto for_each_move = [&](auto visit) {
    parallel_chunks(execution, moves.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end; ++m) visit(m);
    });
  };
  const auto read_records = [&] {
    for_each_move([&](std::size_t m) { records[m] = pool.cells[moves[m].from]; });
  };
  // Tell the neighbors the new numbers: what a facet is called behind it is written by its cell
  // alone. Then move what cells that move were told as well.
  read_records();
  for_each_move([&](std::size_t m) {
    for (int i = 0; i < 4; ++i) {
      const FacetId behind = records[m].neighbors[static_cast<std::size_t>(i)];
      pool.cells[cell_of(behind)].neighbors[static_cast<std::size_t>(index_of(behind))] =
          facet_id(moves[m].to, i);
    }
  });
  read_records();
  for_each_move([&](std::size_t m) { pool.cells[moves[m].to] = records[m]; });
}

}  // namespace

void require_cell_numbers(std::size_t count) {
  if (count <= max_cells) return;
  throw InputError("too many points: the triangulation needs more than " +
                   std::to_string(max_cells) + " tetrahedra, the most that can be numbered");
}

std::size_t compact_cells(CellPool& pool, const Execution& execution) {
  const Exceptions exceptions = exceptions_of(pool, execution);
  const std::size_t live = pool.cells.size() - exceptions.free.size();
  const std::size_t finite = live - exceptions.infinite.size();
  move_cells(pool, moves_into_order(pool, exceptions, finite), execution);
  pool.cells.resize(live);
  pool.marks.resize(live);
  pool.free.clear();
  return finite;
}

}  // namespace cocoon
