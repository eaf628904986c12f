#include "cocone/clean_up/cell_cluster.h"

#include <algorithm>

#include "geom/arrays/sort_ids.h"

namespace cocoon {
namespace {

class Cluster {
 public:
  Cluster(const Triangulation& triangulation, BallCosines& cosines,
          const IdVector<CellId, std::uint8_t>& out, ZeroedArray<CellId, ClusterSize>& known,
          ZeroedArray<CellId, std::uint8_t>& state)
      : triangulation_(triangulation), cosines_(cosines), out_(out), known_(known), state_(state) {}

  CellCluster run(CellId first, double deep_cosine, std::size_t most_cells) {
    const bool too_large = !collect(first, deep_cosine, most_cells);
    const std::size_t core = cells_.size();  // without the slivers
    for (const CellId c : cells_) {
      known_[c] = too_large ? ClusterSize::too_large : ClusterSize::small;
      if (too_large) state_[c] = untouched;
    }
    if (too_large) return {std::move(cells_), true};
    find_samples();
    for (std::size_t k = 0; k < core; ++k) {
      for (int i = 0; i < 4; ++i) take_if_enclosed(triangulation_.neighbor(cells_[k], i));
    }
    for (const CellId c : cells_) state_[c] = untouched;
    for (const CellId c : left_) state_[c] = untouched;
    return {std::move(cells_), false};
  }

 private:
  enum State : std::uint8_t { untouched = 0, taken, left };

  bool on_this_side(CellId c) const { return out_[c] == out_[cells_.front()]; }

  // False if there are more.
  bool collect(CellId first, double deep_cosine, std::size_t most_cells) {
    cells_.push_back(first);
    state_[first] = taken;
    for (std::size_t next = 0; next < cells_.size(); ++next) {
      if (cells_.size() > most_cells) return false;
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(cells_[next], i);
        const CellId behind = cell_of(triangulation_.mirror(f));
        if (state_[behind] == taken || triangulation_.is_infinite(behind)) continue;
        if (!on_this_side(behind)) continue;
        if (cosines_.contact(f) < deep_cosine) continue;
        if (known_[behind] == ClusterSize::too_large) return false;
        state_[behind] = taken;
        cells_.push_back(behind);
      }
    }
    return cells_.size() <= most_cells;
  }

  void find_samples() {
    for (const CellId c : cells_) {
      const auto& vertices = triangulation_.cell(c).vertices;
      samples_.insert(samples_.end(), vertices.begin(), vertices.end());
    }
    make_set(samples_);
  }

  // Infinite cells are not: infinity is no sample.
  bool is_between_samples(CellId c) const {
    const auto& vertices = triangulation_.cell(c).vertices;
    return std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) {
      return std::binary_search(samples_.begin(), samples_.end(), v);
    });
  }

  void take_if_enclosed(CellId first) {
    if (state_[first] != untouched || !on_this_side(first) || !is_between_samples(first)) return;
    std::vector<CellId> piece{first};
    state_[first] = left;
    bool enclosed = true;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation_.neighbor(piece[next], i);
        if (state_[behind] != untouched || !on_this_side(behind)) continue;
        if (!is_between_samples(behind)) {
          enclosed = false;
          continue;
        }
        state_[behind] = left;
        piece.push_back(behind);
      }
    }
    std::vector<CellId>& home = enclosed ? cells_ : left_;
    for (const CellId c : piece) state_[c] = enclosed ? taken : left;
    home.insert(home.end(), piece.begin(), piece.end());
  }

  const Triangulation& triangulation_;
  BallCosines& cosines_;
  const IdVector<CellId, std::uint8_t>& out_;
  ZeroedArray<CellId, ClusterSize>& known_;
  ZeroedArray<CellId, std::uint8_t>& state_;
  std::vector<CellId> cells_;
  std::vector<CellId> left_;  // looked at in vain
  std::vector<VertexId> samples_;
};

}  // namespace

CellCluster cell_cluster(const Triangulation& triangulation, BallCosines& cosines,
                         const IdVector<CellId, std::uint8_t>& out, CellId first,
                         double deep_cosine, std::size_t most_cells,
                         ZeroedArray<CellId, ClusterSize>& known,
                         ZeroedArray<CellId, std::uint8_t>& scratch) {
  return Cluster(triangulation, cosines, out, known, scratch).run(first, deep_cosine, most_cells);
}

bool are_on_one_side(const IdVector<CellId, std::uint8_t>& out, std::span<const CellId> cells) {
  return std::all_of(cells.begin(), cells.end(),
                     [&](CellId c) { return out[c] == out[cells.front()]; });
}

}  // namespace cocoon
