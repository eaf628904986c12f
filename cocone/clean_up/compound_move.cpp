#include "cocone/clean_up/compound_move.h"

#include <set>
#include <utility>

namespace cocoon {

CompoundMove::CompoundMove(const Triangulation& triangulation, SpacingCache& spacings,
                           const DoubtfulRegion& region, CellEnergy& energy, BestMove& best_move,
                           const CleanUpOptions& options)
    : triangulation_(triangulation),
      spacings_(spacings),
      region_(region),
      energy_(energy),
      best_move_(best_move),
      max_rise_(to_energy(options.max_rise)),
      max_openings_(options.max_openings) {}

std::vector<std::vector<CellId>> CompoundMove::find(VertexId v) {
  Energy best_change = 0;
  std::vector<std::vector<CellId>> best;
  for (BestMove::Opening& opening : best_move_.openings(v, max_rise_, max_openings_)) {
    std::vector<std::vector<CellId>> moves{std::move(opening.cells)};
    const Energy change = opening.change + follow(moves);
    for (std::size_t k = moves.size(); k > 0; --k) energy_.flip(moves[k - 1]);
    if (change >= best_change) continue;
    best_change = change;
    best = std::move(moves);
  }
  return best;
}

// Makes the first move and appends those that follow. By how much these change the energy.
Energy CompoundMove::follow(std::vector<std::vector<CellId>>& moves) {
  const auto precedes = [&](VertexId a, VertexId b) { return spacings_.precedes(a, b); };
  std::set<VertexId, decltype(precedes)> turns(precedes);
  const auto make_last = [&] {
    energy_.flip(moves.back());
    for (const CellId c : moves.back()) {
      const auto& vertices = triangulation_.cell(c).vertices;
      turns.insert(vertices.begin(), vertices.end());
    }
  };
  Energy change = 0;
  make_last();
  while (!turns.empty()) {
    const VertexId v = turns.extract(turns.begin()).value();
    if (region_.is_left(v) || energy_.vertex_cost(v) == 0) continue;
    std::vector<CellId> cells = best_move_.find(v);
    if (cells.empty()) continue;
    change += energy_.change(cells);
    moves.push_back(std::move(cells));
    make_last();
  }
  return change;
}

}  // namespace cocoon
