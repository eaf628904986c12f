#include "cocone/clean_up/best_move.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "cocone/facets/cell_order.h"
#include "delaunay/circulate.h"

namespace cocoon {

bool is_attached(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                 std::span<const CellId> cells) {
  for (const CellId c : cells) {
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation.neighbor(c, i);
      if (out[behind] == out[c]) continue;
      if (std::find(cells.begin(), cells.end(), behind) == cells.end()) return true;
    }
  }
  return false;
}

BestMove::BestMove(const Triangulation& triangulation, StarCache& stars,
                   const IdVector<CellId, std::uint8_t>& out, CellEnergy& energy,
                   LabelSplit& label_split, FarReach& far_reach, std::size_t most_cells)
    : triangulation_(triangulation),
      stars_(stars),
      out_(out),
      energy_(energy),
      label_split_(label_split),
      far_reach_(far_reach),
      most_cells_(most_cells) {}

std::vector<CellId> BestMove::find(VertexId v) {
  if (is_too_large(v)) return {};
  best_change_ = 0;
  best_.clear();
  list_candidates(v, -1);
  // Few are asked: so they are no more than a heap.
  const auto later = [](const Candidate& a, const Candidate& b) { return a.least > b.least; };
  std::make_heap(candidates_.begin(), candidates_.end(), later);
  while (!candidates_.empty() && candidates_.front().least <= best_change_) {
    std::pop_heap(candidates_.begin(), candidates_.end(), later);
    consider(std::span(candidates_.back().cells).first(candidates_.back().size));
    candidates_.pop_back();
  }
  for (const std::vector<CellId>& part : large_parts(v)) {
    if (energy_.least_change(part, best_change_) <= best_change_) consider(part);
  }
  return std::exchange(best_, {});
}

std::vector<BestMove::Opening> BestMove::openings(VertexId v, Energy max_rise, std::size_t most) {
  if (is_too_large(v)) return {};
  std::vector<Opening> sets;  // with their bounds
  list_candidates(v, max_rise);
  for (const Candidate& candidate : candidates_) {
    const auto cells = std::span(candidate.cells).first(candidate.size);
    sets.push_back({candidate.least, {cells.begin(), cells.end()}});
  }
  for (std::vector<CellId>& part : large_parts(v)) {
    const Energy least = energy_.least_change(part, max_rise);
    if (least <= max_rise) sets.push_back({least, std::move(part)});
  }
  keep_least(sets, asked_per_opening * most);
  const Energy cost = energy_.vertex_cost(v);
  std::erase_if(sets, [&](Opening& set) {
    if (energy_.vertex_cost_after(v, set.cells) >= cost) return true;
    set.change = energy_.change(set.cells, max_rise);
    return set.change > max_rise || label_split_.splits(set.cells);
  });
  keep_least(sets, most);
  return sets;
}

// In order, and no more than so many.
void BestMove::keep_least(std::vector<Opening>& sets, std::size_t most) const {
  std::sort(sets.begin(), sets.end(), [&](const Opening& a, const Opening& b) {
    return a.change != b.change ? a.change < b.change : precedes(triangulation_, a.cells, b.cells);
  });
  if (sets.size() > most) sets.resize(most);
}

// The single cells and the pairs that could change the energy by at most the limit.
void BestMove::list_candidates(VertexId v, Energy limit) {
  candidates_.clear();
  const bool is_near = energy_.is_unused(v) && far_reach_.is_near_surface(v);
  const auto is_barred = [&](CellId c) { return is_near && far_reach_.reaches_far(c, v); };
  const auto add = [&](Energy least, CellId c, CellId d, std::size_t size) {
    if (least <= limit) candidates_.push_back({least, {c, d}, size});
  };
  for (const CellId c : stars_.star(v)) {
    if (triangulation_.is_infinite(c) || is_barred(c)) continue;
    const int opposite = index_of_vertex(triangulation_.cell(c), v);
    const bool at_surface = energy_.is_at_surface(c);
    std::optional<CellEnergy::BoundsOfCell> bounds;
    if (at_surface) add(bounds.emplace(energy_, c).alone(), c, {}, 1);
    for (int i = 0; i < 4; ++i) {
      const CellId d = triangulation_.neighbor(c, i);
      if (i != opposite && d < c) continue;  // asked from there
      if (out_[c] != out_[d] || triangulation_.is_infinite(d) || is_barred(d)) continue;
      if (!at_surface && !energy_.is_at_surface(d)) continue;
      if (!bounds.has_value()) bounds.emplace(energy_, c);
      add(bounds->with(i), c, d, 2);
    }
  }
}

// The parts into which the surface divides the star of v, but for infinite ones and those that are
// no more than a pair of cells.
std::vector<std::vector<CellId>> BestMove::large_parts(VertexId v) {
  std::vector<std::vector<CellId>> parts = energy_.parts_of_star(v);
  std::erase_if(parts, [&](const std::vector<CellId>& part) {
    const bool infinite = std::any_of(part.begin(), part.end(),
                                      [&](CellId c) { return triangulation_.is_infinite(c); });
    return infinite || part.size() <= 2 || !is_attached(triangulation_, out_, part);
  });
  return parts;
}

void BestMove::consider(std::span<const CellId> cells) {
  const Energy change = energy_.change(cells, best_change_);
  if (change >= 0 || change > best_change_) return;
  if (change == best_change_ && !precedes(triangulation_, cells, best_)) return;
  if (label_split_.splits(cells)) return;
  best_change_ = change;
  best_.assign(cells.begin(), cells.end());
}

}  // namespace cocoon
