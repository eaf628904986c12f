#include "update/grow_regions.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cocoon {

namespace {

// From the lowest free facet, again and again.
Regions grow_one_by_one(const MeshAdjacency& adjacency, const TriangleSet& border) {
  Regions result;
  result.region_of_facet = IdVector<TriangleId, RegionId>(border.size());
  std::vector<TriangleId> stack;
  for (const TriangleId seed : border.ids()) {
    if (border[seed] != 0 || !result.region_of_facet[seed].is_none()) continue;
    const RegionId id = result.regions.push_back({.first = seed});
    result.region_of_facet[seed] = id;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      ++result.regions[id].facets;
      for (const TriangleId across : adjacency.neighbors[t]) {
        if (across.is_none() || border[across] != 0) continue;
        if (!result.region_of_facet[across].is_none()) continue;
        result.region_of_facet[across] = id;
        stack.push_back(across);
      }
    }
  }
  return result;
}

// Fronts that start at the border, each a part of one region, and merge where they meet. In a
// connected model each region has one.
class Fronts {
 public:
  Fronts(const MeshAdjacency& adjacency, const TriangleSet& border)
      : adjacency_(adjacency), border_(border), front_of_(border.size(), none) {
    for (const TriangleId t : border.ids()) {
      if (border[t] == 0) continue;
      for (const TriangleId next : adjacency.neighbors[t]) {
        if (!next.is_none() && border[next] == 0 && front_of_[next] == none) start(next);
      }
    }
  }

  // Until no more than one has anything left to do.
  void grow() {
    while (open_.size() > 1) {
      std::vector<std::uint32_t> still_open;
      for (const std::uint32_t f : open_) {
        if (parent_[f] != f) continue;
        advance(f);
      }
      for (const std::uint32_t f : open_) {
        if (parent_[f] == f && !stacks_[f].empty()) still_open.push_back(f);
      }
      open_ = std::move(still_open);
    }
  }

  // The facets that were not reached are of the front that is still open. Precondition: grow().
  Regions regions() {
    const std::uint32_t rest = open_.empty() ? none : open_.front();  // none: all were reached
    IdVector<RegionId, Region> found;
    std::vector<RegionId> region_of_front(parent_.size());
    Regions result;
    result.region_of_facet = IdVector<TriangleId, RegionId>(border_.size());
    for (const TriangleId t : border_.ids()) {
      if (border_[t] != 0) continue;
      const std::uint32_t f = front_of_[t] == none ? rest : root_of(front_of_[t]);
      RegionId& region = region_of_front[f];
      if (region.is_none()) region = found.push_back({.first = t});
      ++found[region].facets;
      result.region_of_facet[t] = region;
    }
    result.regions = std::move(found);
    return result;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  // Facets that a front passes in one turn.
  static constexpr std::size_t pace = 64;

  void start(TriangleId t) {
    const auto f = static_cast<std::uint32_t>(parent_.size());
    parent_.push_back(f);
    stacks_.push_back({t});
    front_of_[t] = f;
    open_.push_back(f);
  }

  std::uint32_t root_of(std::uint32_t f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }

  void advance(std::uint32_t f) {
    for (std::size_t step = 0; step < pace && !stacks_[f].empty(); ++step) {
      const TriangleId t = stacks_[f].back();
      stacks_[f].pop_back();
      for (const TriangleId next : adjacency_.neighbors[t]) {
        if (next.is_none() || border_[next] != 0) continue;
        if (front_of_[next] == none) {
          front_of_[next] = f;
          stacks_[f].push_back(next);
        } else {
          take_in(root_of(front_of_[next]), f);
        }
      }
    }
  }

  // The other front becomes part of f.
  void take_in(std::uint32_t other, std::uint32_t f) {
    if (other == f) return;
    parent_[other] = f;
    if (stacks_[other].size() > stacks_[f].size()) std::swap(stacks_[other], stacks_[f]);
    stacks_[f].insert(stacks_[f].end(), stacks_[other].begin(), stacks_[other].end());
    stacks_[other] = {};
  }

  const MeshAdjacency& adjacency_;
  const TriangleSet& border_;
  IdVector<TriangleId, std::uint32_t> front_of_;
  std::vector<std::uint32_t> parent_;            // of each front: what it became part of, or itself
  std::vector<std::vector<TriangleId>> stacks_;  // facets whose neighbors are to be looked at
  std::vector<std::uint32_t> open_;
};

}  // namespace

Regions grow_regions(const ModelIndex& model, const TriangleSet& border) {
  const bool has_border =
      std::any_of(border.begin(), border.end(), [](std::uint8_t flag) { return flag != 0; });
  if (!model.is_connected() || !has_border) return grow_one_by_one(model.adjacency(), border);
  Fronts fronts(model.adjacency(), border);
  fronts.grow();
  return fronts.regions();
}

}  // namespace cocoon
