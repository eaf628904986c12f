#include "cocone/clean_up/vertex_repairs.h"

#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace cocoon {

namespace {

using Turns =
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<std::uint32_t>>;

}  // namespace

VertexRepairs::VertexRepairs(ChangingLabels& labels, const CleanUpOptions& options,
                             const Execution& execution)
    : labels_(labels),
      execution_(execution),
      makes_compound_moves_(options.max_rise != 0),
      best_move_(labels.triangulation, labels.stars, labels.out, labels.energy, labels.split,
                 labels.far_reach, options.most_move_cells),
      compound_move_(labels.triangulation, labels.spacings, labels.region, labels.energy,
                     best_move_, options) {}

void VertexRepairs::move(CleanUpCounters& counters) {
  DoubtfulRegion& region = labels_.region;
  std::vector<VertexId> turns = labels_.flawed_vertices();
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<VertexId> later;
    Turns now;
    for (const VertexId v : turns) {
      if (region.contains(v)) now.push(region.rank[v]);  // else left alone
    }
    while (!now.empty()) {
      const std::uint32_t rank = now.top();
      while (!now.empty() && now.top() == rank) now.pop();
      const VertexId v = region.vertices[rank - 1];
      tell_turn();
      while (labels_.energy.vertex_cost(v) != 0) {
        const std::vector<CellId> cells = best_move_.find(v);
        if (cells.empty()) {
          later.push_back(v);
          break;
        }
        labels_.flip(cells);
        ++counters.moves;
        counters.moved_cells += cells.size();
        changed = true;
        for (const CellId c : cells) {
          for (const VertexId w : labels_.triangulation.cell(c).vertices) {
            if (region.rank[w] > rank) now.push(region.rank[w]);
            if (region.rank[w] < rank) later.push_back(w);
          }
        }
      }
    }
    turns = std::move(later);
    extend_region(labels_.stars, labels_.spacings, turns, region);
  }
}

// Moves take long where much is in doubt: somebody may want to stop.
void VertexRepairs::tell_turn() {
  constexpr std::size_t turns_per_report = 64;
  if (++turns_ % turns_per_report == 0) report_progress(execution_, "clean_up_cells", 0.5);
}

bool VertexRepairs::make_compound_moves(CleanUpCounters& counters) {
  if (!makes_compound_moves_) return false;
  bool changed = false;
  for (const VertexId v : labels_.flawed_vertices()) {
    while (labels_.energy.vertex_cost(v) != 0) {
      const std::vector<std::vector<CellId>> moves = compound_move_.find(v);
      if (moves.empty()) break;
      for (const std::vector<CellId>& cells : moves) {
        labels_.flip(cells);
        counters.compound_cells += cells.size();
      }
      ++counters.compound_moves;
      changed = true;
    }
  }
  return changed;
}

}  // namespace cocoon
