#include "cocone/best_move.h"

#include <algorithm>
#include <utility>

#include "cocone/cell_order.h"
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
                   SideSplit& side_split)
    : triangulation_(triangulation),
      stars_(stars),
      out_(out),
      energy_(energy),
      side_split_(side_split) {}

std::vector<CellId> BestMove::find(VertexId v) {
  best_change_ = 0;
  best_.clear();
  list_candidates(v);
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.least < b.least; });
  for (const Candidate& candidate : candidates_) {
    if (candidate.least > best_change_) break;
    consider(std::span(candidate.cells).first(candidate.size));
  }
  consider_parts(v);
  return std::exchange(best_, {});
}

// The single cells and the pairs that could lower the energy.
void BestMove::list_candidates(VertexId v) {
  candidates_.clear();
  const auto add = [&](Energy least, CellId c, CellId d, std::size_t size) {
    if (least < 0) candidates_.push_back({least, {c, d}, size});
  };
  for (const CellId c : stars_.star(v)) {
    if (triangulation_.is_infinite(c)) continue;
    const bool at_surface = energy_.is_at_surface(c);
    if (at_surface) add(energy_.least_change(c), c, {}, 1);
    for (int i = 0; i < 4; ++i) {
      const CellId d = triangulation_.neighbor(c, i);
      if (out_[c] != out_[d] || triangulation_.is_infinite(d)) continue;
      if (has_vertex(triangulation_.cell(d), v) && d < c) continue;  // asked from there
      if (at_surface || energy_.is_at_surface(d)) add(energy_.least_change_with(c, i), c, d, 2);
    }
  }
}

// The parts into which the surface divides the star of v.
void BestMove::consider_parts(VertexId v) {
  for (const std::vector<CellId>& part : energy_.parts_of_star(v)) {
    const bool finite = std::none_of(part.begin(), part.end(),
                                     [&](CellId c) { return triangulation_.is_infinite(c); });
    if (!finite || part.size() <= 2 || !is_attached(triangulation_, out_, part)) continue;
    if (energy_.least_change(part, best_change_) <= best_change_) consider(part);
  }
}

void BestMove::consider(std::span<const CellId> cells) {
  const Energy change = energy_.change(cells, best_change_);
  if (change >= 0 || change > best_change_) return;
  if (change == best_change_ && !precedes(triangulation_, cells, best_)) return;
  if (side_split_.splits(cells)) return;
  best_change_ = change;
  best_.assign(cells.begin(), cells.end());
}

}  // namespace cocoon
