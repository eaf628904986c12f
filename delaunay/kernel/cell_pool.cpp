#include "delaunay/kernel/cell_pool.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/parallel/parallel_list.h"

namespace cocoon {
namespace {

constexpr std::size_t grain = std::size_t{1} << 14;
constexpr std::size_t ahead = 8;  // records lie anywhere in memory: fetch those that come soon

// No place occurs twice.
void exchange_cells(CellPool& pool, std::span<const CellExchange> exchanges,
                    const Execution& execution) {
  const auto for_each = [&](auto visit) {
    parallel_chunks(execution, exchanges.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) visit(k);
    });
  };
  const auto fetch_soon = [&](std::size_t k) {
    if (k + ahead >= exchanges.size()) return;
    __builtin_prefetch(&pool.cells[exchanges[k + ahead].a]);
    __builtin_prefetch(&pool.cells[exchanges[k + ahead].b]);
  };
  using Neighbors = std::array<FacetId, 4>;
  struct NeighborsOfBoth {
    Neighbors a, b;
    bool a_is_free;
  };
  std::vector<NeighborsOfBoth, OverwriteAllocator<NeighborsOfBoth>> around(exchanges.size());
  for_each([&](std::size_t k) {
    fetch_soon(k);
    const auto [a, b] = exchanges[k];
    around[k] = {pool.cells[a].neighbors, pool.cells[b].neighbors, pool.is_free(a)};
  });
  // What a facet is called behind it is written by its own cell alone.
  const auto record_behind = [&](FacetId facet) -> Cell& { return pool.cells[cell_of(facet)]; };
  const auto tell = [&](const Neighbors& neighbors, CellId new_number) {
    for (int i = 0; i < 4; ++i) {
      const FacetId behind = neighbors[static_cast<std::size_t>(i)];
      record_behind(behind).neighbors[static_cast<std::size_t>(index_of(behind))] =
          facet_id(new_number, i);
    }
  };
  for_each([&](std::size_t k) {
    if (k + ahead < exchanges.size()) {
      const NeighborsOfBoth& soon = around[k + ahead];
      for (const FacetId f : soon.b) __builtin_prefetch(&record_behind(f));
      if (!soon.a_is_free) {
        for (const FacetId f : soon.a) __builtin_prefetch(&record_behind(f));
      }
    }
    if (!around[k].a_is_free) tell(around[k].a, exchanges[k].b);
    tell(around[k].b, exchanges[k].a);
  });
  for_each([&](std::size_t k) {
    fetch_soon(k);
    std::swap(pool.cells[exchanges[k].a], pool.cells[exchanges[k].b]);
  });
}

// Fills the holes with the last live cells.
std::vector<CellExchange> drop_free_cells(CellPool& pool, const Execution& execution) {
  std::sort(pool.free.begin(), pool.free.end());
  std::vector<CellExchange> exchanges;
  std::size_t live = pool.cells.size();
  for (const CellId hole : pool.free) {
    while (live > hole.index() && pool.is_free(CellId(live - 1))) --live;
    if (live <= hole.index()) break;
    exchanges.push_back({hole, CellId(--live)});
  }
  exchange_cells(pool, exchanges, execution);
  pool.cells.resize(live);
  pool.marks.resize(live);
  pool.free.clear();
  return exchanges;
}

// The infinite cells in increasing order.
std::vector<CellId> infinite_cells(const CellPool& pool, const Execution& execution) {
  return parallel_list<CellId>(execution, pool.cells.size(), grain,
                               [&](std::size_t begin, std::size_t end, std::vector<CellId>& found) {
                                 for (std::size_t c = begin; c < end; ++c) {
                                   if (pool.is_infinite(CellId(c))) found.push_back(CellId(c));
                                 }
                               });
}

}  // namespace

void require_cell_numbers(std::size_t count) {
  if (count <= max_cells) return;
  throw InputError("too many points: the triangulation needs more than " +
                   std::to_string(max_cells) + " tetrahedra, the most that can be numbered");
}

void take_places(CellPool& pool, std::vector<CellId>& free, std::span<const CellId> own,
                 std::size_t count, std::vector<CellId>& places) {
  const std::size_t reused = std::min(count, own.size());
  const std::size_t taken = std::min(count - reused, free.size());
  const std::size_t added = count - reused - taken;
  const std::size_t end = pool.cells.size();
  if (added > 0) require_cell_numbers(end + added);
  places.assign(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(reused));
  places.insert(places.end(), free.rbegin(), free.rbegin() + static_cast<std::ptrdiff_t>(taken));
  free.resize(free.size() - taken);
  for (std::size_t i = own.size(); i-- > reused;) {
    pool.cells[own[i]].vertices[0] = VertexId();
    free.push_back(own[i]);
  }
  if (added == 0) return;
  for (std::size_t i = 0; i < added; ++i) places.push_back(CellId(end + i));
  pool.cells.resize_for_overwrite(end + added);
  pool.marks.resize(end + added, CellMark::untested);
}

std::size_t compact_cells(CellPool& pool, const Execution& execution,
                          std::vector<CellExchange>* done) {
  std::vector<CellExchange> into_holes = drop_free_cells(pool, execution);
  if (done != nullptr) *done = std::move(into_holes);
  // Exchange the infinite cells before the place where they are to begin with the finite ones
  // behind it.
  const std::vector<CellId> infinite = infinite_cells(pool, execution);
  const CellId end_of_finite(pool.cells.size() - infinite.size());
  const auto behind = std::lower_bound(infinite.begin(), infinite.end(), end_of_finite);
  const auto num_before = static_cast<std::size_t>(behind - infinite.begin());
  std::vector<CellExchange> exchanges;
  exchanges.reserve(num_before);
  CellId place = end_of_finite;
  for (auto skipped = behind; exchanges.size() < num_before; ++place) {
    if (skipped != infinite.end() && *skipped == place) {
      ++skipped;
    } else {
      exchanges.push_back({infinite[exchanges.size()], place});
    }
  }
  exchange_cells(pool, exchanges, execution);
  if (done != nullptr) done->insert(done->end(), exchanges.begin(), exchanges.end());
  return end_of_finite.index();
}

}  // namespace cocoon
