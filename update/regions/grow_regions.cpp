#include "update/regions/grow_regions.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geom/arrays/sparse_vector.h"

namespace cocoon {

namespace {

// From the lowest free facet, again and again.
Regions grow_one_by_one(const TriangleNeighbors& neighbors, const TriangleSet& border) {
  Regions result;
  result.region_of_facet = SparseVector<TriangleId, RegionId>(border.size());
  std::vector<TriangleId> stack;
  for (const TriangleId seed : border.ids()) {
    if (border[seed] != 0 || !result.region_of_facet[seed].is_none()) continue;
    const RegionId id = result.regions.push_back({.first = seed});
    result.region_of_facet.set(seed, id);
    stack.assign(1, seed);
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      ++result.regions[id].facets;
      for (const TriangleId across : neighbors[t]) {
        if (across.is_none() || border[across] != 0) continue;
        if (!result.region_of_facet[across].is_none()) continue;
        result.region_of_facet.set(across, id);
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
  // `facets`: those of the border.
  Fronts(const TriangleNeighbors& neighbors, const TriangleSet& border,
         std::span<const TriangleId> facets)
      : neighbors_(neighbors), border_(border), facets_(facets), front_of_(border.size()) {
    for (const TriangleId t : facets) {
      for (const TriangleId next : neighbors[t]) {
        if (!next.is_none() && border[next] == 0 && front_of_[next] == 0) start(next);
      }
    }
  }

  bool any() const { return !parent_.empty(); }

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

  // The facets that were not reached are of the front that is still open. Precondition: grow(), and
  // a front.
  Regions regions() {
    const std::uint32_t rest = open_.empty() ? root_of(0) : open_.front();
    std::vector<Region> found(parent_.size());  // of each root
    std::size_t facets = border_.size() - facets_.size();
    for (const TriangleId t : reached_) {
      Region& region = found[root_of(front_of_[t] - 1)];
      region.first = std::min(region.first, t);  // none is above all
      ++region.facets;
    }
    for (std::uint32_t f = 0; f < found.size(); ++f) facets -= f == rest ? 0 : found[f].facets;
    found[rest] = {.first = first_of_rest(rest), .facets = facets};

    std::vector<std::uint32_t> roots;
    for (std::uint32_t f = 0; f < found.size(); ++f) {
      if (found[f].facets > 0) roots.push_back(f);
    }
    std::sort(roots.begin(), roots.end(),
              [&](std::uint32_t a, std::uint32_t b) { return found[a].first < found[b].first; });
    Regions result;
    std::vector<RegionId> region_of_front(parent_.size());
    for (const std::uint32_t f : roots) region_of_front[f] = result.regions.push_back(found[f]);
    label(region_of_front, rest, result);
    return result;
  }

 private:
  // Facets that a front passes in one turn.
  static constexpr std::size_t pace = 64;

  void start(TriangleId t) {
    const auto f = static_cast<std::uint32_t>(parent_.size());
    parent_.push_back(f);
    stacks_.push_back({t});
    reach(t, f);
    open_.push_back(f);
  }

  void reach(TriangleId t, std::uint32_t f) {
    front_of_.set(t, f + 1);
    reached_.push_back(t);
  }

  TriangleId first_of_rest(std::uint32_t rest) {
    for (const TriangleId t : border_.ids()) {
      if (border_[t] != 0) continue;
      if (front_of_[t] == 0 || root_of(front_of_[t] - 1) == rest) return t;
    }
    return {};
  }

  void label(const std::vector<RegionId>& region_of_front, std::uint32_t rest, Regions& result) {
    result.region_of_facet =
        SparseVector<TriangleId, RegionId>(border_.size(), region_of_front[rest]);
    for (const TriangleId t : reached_) {
      result.region_of_facet.set(t, region_of_front[root_of(front_of_[t] - 1)]);
    }
    for (const TriangleId t : facets_) result.region_of_facet.set(t, RegionId());
  }

  std::uint32_t root_of(std::uint32_t f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }

  void advance(std::uint32_t f) {
    for (std::size_t step = 0; step < pace && !stacks_[f].empty(); ++step) {
      const TriangleId t = stacks_[f].back();
      stacks_[f].pop_back();
      for (const TriangleId next : neighbors_[t]) {
        if (next.is_none() || border_[next] != 0) continue;
        if (front_of_[next] == 0) {
          reach(next, f);
          stacks_[f].push_back(next);
        } else {
          take_in(root_of(front_of_[next] - 1), f);
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

  const TriangleNeighbors& neighbors_;
  const TriangleSet& border_;
  std::span<const TriangleId> facets_;
  SparseVector<TriangleId, std::uint32_t> front_of_;  // 1 + its front; 0: not reached
  std::vector<TriangleId> reached_;
  std::vector<std::uint32_t> parent_;            // of each front: what it became part of, or itself
  std::vector<std::vector<TriangleId>> stacks_;  // facets whose neighbors are to be looked at
  std::vector<std::uint32_t> open_;
};

}  // namespace

Regions grow_regions(const ModelIndex& model, const TriangleSet& border) {
  if (!model.is_connected()) return grow_one_by_one(model.neighbors(), border);
  const std::vector<TriangleId> facets = members(border);
  Fronts fronts(model.neighbors(), border, facets);
  if (!fronts.any()) return grow_one_by_one(model.neighbors(), border);
  fronts.grow();
  return fronts.regions();
}

}  // namespace cocoon
