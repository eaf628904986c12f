#include "cocone/clean_up/kept_reach.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {
namespace {

class KeptReach {
 public:
  KeptReach(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
            std::span<const CellId> changed, std::size_t most_cells)
      : triangulation_(triangulation),
        out_(out),
        changed_(changed),
        most_cells_(most_cells),
        kind_(triangulation.num_cells()),
        met_by_(triangulation.num_cells()) {}

  bool run() {
    for (const CellId c : changed_) kind_[c] = Kind::changed;
    for (const CellId c : changed_) {
      if (kind_[c] == Kind::changed && !is_kept_around(collect_set(c))) return false;
    }
    return true;
  }

 private:
  enum class Kind : std::uint8_t { same = 0, changed, collected };

  // The changed cells that hang together with one of them.
  std::vector<CellId> collect_set(CellId first) {
    std::vector<CellId> cells{first};
    kind_[first] = Kind::collected;
    for (std::size_t next = 0; next < cells.size(); ++next) {
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation_.neighbor(cells[next], i);
        if (kind_[behind] != Kind::changed) continue;
        kind_[behind] = Kind::collected;
        cells.push_back(behind);
      }
    }
    return cells;
  }

  // From all OUT cells in the set and beside it at once, until all have met.
  bool is_kept_around(const std::vector<CellId>& set) {
    met_.clear();
    bool has_old = false;  // an OUT cell that was OUT before: joined to infinity
    for (const CellId c : set) {
      meet_first(c);
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation_.neighbor(c, i);
        meet_first(behind);
        has_old = has_old || (out_[behind] != 0 && kind_[behind] == Kind::same);
      }
    }
    const bool kept = met_.empty() || (has_old && hang_together());
    for (const CellId c : met_) met_by_[c] = 0;
    return kept;
  }

  void meet_first(CellId c) {
    if (out_[c] == 0 || met_by_[c] != 0) return;
    met_.push_back(c);
    met_by_[c] = static_cast<std::uint32_t>(met_.size());
  }

  bool hang_together() {
    std::size_t parts = met_.size();
    DisjointSets starts(parts);
    for (std::size_t next = 0; next < met_.size() && parts > 1; ++next) {
      if (met_.size() > most_cells_) return false;
      const std::uint32_t start = met_by_[met_[next]];
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation_.neighbor(met_[next], i);
        if (out_[behind] == 0) continue;
        if (met_by_[behind] == 0) {
          met_by_[behind] = start;
          met_.push_back(behind);
        } else if (starts.join(start - 1, met_by_[behind] - 1)) {
          --parts;
        }
      }
    }
    return parts == 1;
  }

  const Triangulation& triangulation_;
  const IdVector<CellId, std::uint8_t>& out_;
  std::span<const CellId> changed_;
  std::size_t most_cells_;
  ZeroedArray<CellId, Kind> kind_;
  ZeroedArray<CellId, std::uint32_t> met_by_;  // 1 + the start that came first; 0: none
  std::vector<CellId> met_;
};

}  // namespace

bool is_reach_kept(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                   std::span<const CellId> changed, std::size_t most_cells) {
  return KeptReach(triangulation, out, changed, most_cells).run();
}

IdVector<CellId, std::uint8_t> reached_from_infinity(const Triangulation& triangulation,
                                                     const IdVector<CellId, std::uint8_t>& out) {
  IdVector<CellId, std::uint8_t> reached(triangulation.num_cells(), 0);
  std::vector<CellId> infinite;
  for (const CellId c : triangulation.infinite_cells()) infinite.push_back(c);
  extend_reach(triangulation, out, std::move(infinite), reached);
  return reached;
}

void extend_reach(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                  std::vector<CellId> cells, IdVector<CellId, std::uint8_t>& reached) {
  for (const CellId c : cells) reached[c] = 1;
  while (!cells.empty()) {
    const CellId c = cells.back();
    cells.pop_back();
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation.neighbor(c, i);
      if (reached[behind] != 0 || out[behind] == 0) continue;
      reached[behind] = 1;
      cells.push_back(behind);
    }
  }
}

}  // namespace cocoon
