#include "cocone/clean_up/handle_closing.h"

#include <algorithm>

#include "cocone/clean_up/best_move.h"
#include "cocone/facets/cell_order.h"

namespace cocoon {

HandleClosing::HandleClosing(const Triangulation& triangulation, StarCache& stars,
                             BallCosines& cosines, const DoubtfulRegion& region,
                             const IdVector<CellId, std::uint8_t>& out, CellEnergy& energy,
                             const CleanUpOptions& options)
    : triangulation_(triangulation),
      stars_(stars),
      cosines_(cosines),
      region_(region),
      out_(out),
      energy_(energy),
      handle_cost_(to_energy(options.handle_cost)),
      max_rise_(to_energy(options.max_rise)),
      max_closing_rise_(to_energy(options.max_closing_rise)) {}

std::size_t HandleClosing::count_cells_at(std::span<const VertexId> loop) {
  std::size_t count = 0;
  for (const VertexId v : loop) count += stars_.star(v).size();
  return count;
}

std::vector<CellId> HandleClosing::find(std::span<const VertexId> loop, std::uint8_t side) {
  list_window(loop, side);
  std::vector<CellId> flips;
  Energy change = flip_to_closing(flips);
  change += go_back(flips);
  const bool pays = change < 0 && change <= max_closing_rise_ - handle_cost_ && hang_on(flips);
  for (const CellId c : flips) energy_.flip({&c, 1});
  for (const Entry& entry : window_) place_[entry.cell] = 0;
  if (!pays) flips.clear();
  return flips;
}

// Do the cells hang together with others on the side where they are now, if through each other?
bool HandleClosing::hang_on(std::vector<CellId> cells) const {
  const auto holds = [&](CellId c) {
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation_.neighbor(c, i);
      if (out_[behind] != out_[c]) continue;
      if (std::find(cells.begin(), cells.end(), behind) == cells.end()) return true;
    }
    return false;
  };
  for (;;) {
    const auto held = std::find_if(cells.begin(), cells.end(), holds);
    if (held == cells.end()) return cells.empty();
    cells.erase(held);
  }
}

void HandleClosing::list_window(std::span<const VertexId> loop, std::uint8_t side) {
  if (place_.size() == 0) place_ = ZeroedArray<CellId, std::uint32_t>(triangulation_.num_cells());
  window_.clear();
  for (const CellId c : stars_.cells_at(loop)) {
    if (out_[c] != side || triangulation_.is_infinite(c) || cosines_.is_flat(c)) continue;
    if (has_left_vertex(triangulation_, region_, c)) continue;
    window_.push_back({c, 0, Entry::apart});
    place_[c] = static_cast<std::uint32_t>(window_.size());
  }
  for (Entry& entry : window_) bound(entry);
}

void HandleClosing::bound(Entry& entry) {
  const bool attached = is_attached(triangulation_, out_, {&entry.cell, 1});
  entry.state = attached ? Entry::bounded : Entry::apart;
  if (attached) entry.change = energy_.least_change(entry.cell);
}

// What has a vertex in common with a cell that was flipped.
void HandleClosing::bound_around(CellId c) {
  for (const CellId other : stars_.cells_at(triangulation_.cell(c).vertices)) {
    if (place_[other] == 0) continue;
    Entry& entry = window_[place_[other] - 1];
    if (entry.state != Entry::flipped) bound(entry);
  }
}

// Only what promises to be the cheapest is asked for its change.
HandleClosing::Entry* HandleClosing::cheapest() {
  const auto precedes = [&](const Entry& a, const Entry& b) {
    if (a.change != b.change) return a.change < b.change;
    if (a.state != b.state) return a.state == Entry::bounded;  // may be as cheap
    return sorted_corners(triangulation_, a.cell) < sorted_corners(triangulation_, b.cell);
  };
  for (;;) {
    Entry* best = nullptr;
    for (Entry& entry : window_) {
      if (entry.state != Entry::bounded && entry.state != Entry::known) continue;
      if (best == nullptr || precedes(entry, *best)) best = &entry;
    }
    if (best == nullptr || best->state == Entry::known) return best;
    best->change = energy_.change({&best->cell, 1});
    best->state = Entry::known;
  }
}

// Flips, and by how much they change the energy; none if it nowhere falls by a handle's cost.
Energy HandleClosing::flip_to_closing(std::vector<CellId>& flips) {
  Energy change = 0;
  Energy highest = 0;
  Energy lowest = 0;  // where it has fallen so far
  std::size_t count = 0;
  for (Entry* next = cheapest(); next != nullptr; next = cheapest()) {
    change += next->change;
    if (change > max_rise_) break;
    next->state = Entry::flipped;
    energy_.flip({&next->cell, 1});
    flips.push_back(next->cell);
    bound_around(next->cell);
    highest = std::max(highest, change);
    if (highest - change < handle_cost_ || (count != 0 && change >= lowest)) continue;
    lowest = change;
    count = flips.size();
  }
  for (; flips.size() > count; flips.pop_back()) energy_.flip({&flips.back(), 1});
  return lowest;
}

Energy HandleClosing::go_back(std::vector<CellId>& flips) {
  Energy change = 0;
  for (bool any = true; any;) {
    any = false;
    for (std::size_t k = flips.size(); k > 0; --k) {
      const std::span<const CellId> cells(&flips[k - 1], 1);
      if (!is_attached(triangulation_, out_, cells)) continue;
      const Energy gain = energy_.change(cells);
      if (gain >= 0) continue;
      energy_.flip(cells);
      change += gain;
      flips.erase(flips.begin() + static_cast<std::ptrdiff_t>(k - 1));
      any = true;
    }
  }
  return change;
}

}  // namespace cocoon
