// Filling a tunnel or cutting a neck (clean_up_cells.h, step 6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cocone/clean_up_cells.h"
#include "cocone/energy/ball_cosines.h"
#include "cocone/energy/cell_energy.h"
#include "cocone/energy/doubtful_region.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {

class HandleClosing {
 public:
  // All references must outlive the object. O(1). `out`: the side of each cell, 0 or 1.
  HandleClosing(const Triangulation& triangulation, StarCache& stars, BallCosines& cosines,
                const DoubtfulRegion& region, const IdVector<CellId, std::uint8_t>& out,
                CellEnergy& energy, const CleanUpOptions& options);

  // Cells at the loop's vertices, once for each of these. O(1).
  std::size_t count_cells_at(std::span<const VertexId> loop);

  // Cells at the loop, all on `side` (1: OUT), whose flip closes a handle there, and lowers the
  // energy by all of handle_cost but max_closing_rise at most; empty if there are none. The
  // labeling is as before. Cells at the loop's vertices change sides one by one, each time the one
  // with the least change (ties by cell_order.h) of those that hang together with the other side,
  // until the energy has risen by max_rise. Of the states in which the handle is closed (the energy
  // has fallen by handle_cost), the one with the lowest energy is restored. Then cells whose return
  // to their old side lowers the energy return, one by one. Flat cells, and those with a vertex
  // that is left alone, do not change. Complexity: k flips of w cells at the loop,
  // each followed by the changes of what has a vertex in common: O(k w stars).
  // Source: Kernighan & Lin 1970 (the best of a series of moves each of which may be a loss).
  std::vector<CellId> find(std::span<const VertexId> loop, std::uint8_t side);

 private:
  struct Entry {
    CellId cell;
    Energy change;  // known, or no less than that
    enum : std::uint8_t { apart, bounded, known, flipped } state;
  };
  void list_window(std::span<const VertexId> loop, std::uint8_t side);
  void bound(Entry& entry);
  void bound_around(CellId c);
  Entry* cheapest();
  Energy flip_to_closing(std::vector<CellId>& flips);
  Energy go_back(std::vector<CellId>& flips);
  bool hang_on(std::vector<CellId> cells) const;

  const Triangulation& triangulation_;
  StarCache& stars_;
  BallCosines& cosines_;
  const DoubtfulRegion& region_;
  const IdVector<CellId, std::uint8_t>& out_;
  CellEnergy& energy_;
  Energy handle_cost_;
  Energy max_rise_;
  Energy max_closing_rise_;
  std::vector<Entry> window_;
  ZeroedArray<CellId, std::uint32_t> place_;  // 1 + that in window_; zero between questions
};

}  // namespace cocoon
