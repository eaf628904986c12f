#include "cocone/extract_manifold.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "delaunay/circulate.h"

namespace cocoon {
namespace {

constexpr std::uint32_t unclassified = 0xFFFFFFFFU;

using Corners = std::array<Point, 3>;

// Numbers the half-facets of a set 0, 1, 2, ... in the order of their ids.
class HalfFacetIndex {
 public:
  HalfFacetIndex(const Triangulation& triangulation, const FacetSet& facets)
      : facets_(facets), offsets_(triangulation.num_cells()) {
    std::uint32_t count = 0;
    for (const CellId c : triangulation.cells()) {
      offsets_[c] = count;
      count += static_cast<std::uint32_t>(std::popcount(facets.bits(c)));
    }
    count_ = count;
  }
  std::size_t count() const { return count_; }
  std::uint32_t operator()(FacetId f) const {
    const unsigned before = facets_.bits(cell_of(f)) & ((1U << index_of(f)) - 1U);
    return offsets_[cell_of(f)] + static_cast<std::uint32_t>(std::popcount(before));
  }

 private:
  const FacetSet& facets_;
  IdVector<CellId, std::uint32_t> offsets_;
  std::uint32_t count_ = 0;
};

// A class of half-facets: a range of the list of members.
struct HalfClass {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool rejected = false;  // shares a vertex with what was kept before it was found
  std::size_t size() const { return end - begin; }
};

class Extraction {
 public:
  Extraction(const Triangulation& triangulation, const FacetSet& candidates,
             const VertexSet& umbrella)
      : triangulation_(triangulation),
        candidates_(candidates),
        umbrella_(umbrella),
        index_(triangulation, candidates),
        class_of_(index_.count(), unclassified),
        kept_(triangulation.num_cells()),
        on_surface_(triangulation.num_vertices(), 0) {}

  ManifoldSurface run() {
    keep_classes_seen_from_outside();
    keep_classes_apart();
    result_.facets = std::move(kept_);
    result_.dropped = candidates_.size() - result_.halves.size();
    std::sort(result_.halves.begin(), result_.halves.end());
    return std::move(result_);
  }

 private:
  void keep_classes_seen_from_outside() {
    std::vector<HalfClass> classes;
    for (const CellId c : triangulation_.infinite_cells()) {
      const FacetId hull_facet = facet_id(c, 3);
      if (candidates_.contains(hull_facet) && class_of_[index_(hull_facet)] == unclassified) {
        classes.push_back(flood(hull_facet));
      }
    }
    sort_canonically(classes);
    for (const HalfClass& c : classes) {
      if (!shares_facet_with_kept(c)) keep(c);
    }
  }

  void keep_classes_apart() {
    std::vector<HalfClass> classes;
    for (const CellId c : triangulation_.cells()) {
      if (candidates_.bits(c) == 0) continue;
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (!candidates_.contains(f) || class_of_[index_(f)] != unclassified) continue;
        if (touches_surface(f)) continue;
        const HalfClass found = flood(f);
        if (!found.rejected) classes.push_back(found);
      }
    }
    sort_canonically(classes);
    for (const HalfClass& c : classes) {
      const bool apart =
          std::none_of(begin(c), end(c), [&](FacetId f) { return touches_surface(f); });
      if (apart) keep(c);
    }
  }

  HalfClass flood(FacetId seed) {
    const auto number = static_cast<std::uint32_t>(num_classes_++);
    HalfClass found{members_.size(), 0, false};
    class_of_[index_(seed)] = number;
    members_.push_back(seed);
    for (std::size_t next = found.begin; next < members_.size(); ++next) {
      const FacetId f = members_[next];
      found.rejected |= touches_surface(f);
      const std::array<VertexId, 3> v = triangulation_.facet_vertices(f);
      for (std::size_t i = 0; i < 3; ++i) {
        if (umbrella_[v[i]] == 0 && umbrella_[v[(i + 1) % 3]] == 0) continue;
        const FacetId g = rotate(f, v[(i + 2) % 3]);
        std::uint32_t& class_of_g = class_of_[index_(g)];
        if (class_of_g == number || g == triangulation_.mirror(f)) continue;
        class_of_g = number;
        members_.push_back(g);
      }
    }
    found.end = members_.size();
    return found;
  }

  // From the half-facet f, about its edge opposite `third`, to the first candidate on its side.
  FacetId rotate(FacetId f, VertexId third) const {
    for (;;) {
      const Cell& cell = triangulation_.cell(cell_of(f));
      const FacetId g = facet_id(cell_of(f), index_of_vertex(cell, third));
      if (candidates_.contains(g)) return g;
      third = triangulation_.opposite_vertex(f);
      f = triangulation_.mirror(g);
    }
  }

  bool touches_surface(FacetId f) const {
    const auto [a, b, c] = triangulation_.facet_vertices(f);
    return (on_surface_[a] | on_surface_[b] | on_surface_[c]) != 0;
  }

  bool shares_facet_with_kept(const HalfClass& c) const {
    return std::any_of(begin(c), end(c), [&](FacetId f) { return kept_.contains(f); });
  }

  void keep(const HalfClass& c) {
    ++result_.components;
    for (auto f = begin(c); f != end(c); ++f) {
      if (kept_.contains(*f)) {  // its back is in the same class
        ++result_.two_sided;
        continue;
      }
      kept_.insert(triangulation_, *f);
      const FacetId mirror = triangulation_.mirror(*f);
      const bool both = class_of_[index_(mirror)] == class_of_[index_(*f)];
      result_.halves.push_back(both && !sees_positive_side(*f) ? mirror : *f);
      for (const VertexId v : triangulation_.facet_vertices(*f)) on_surface_[v] = 1;
    }
  }

  // Canonical order of classes.
  struct Rank {
    std::size_t size;
    Corners smallest;
    bool positive;
  };

  void sort_canonically(std::vector<HalfClass>& classes) const {
    if (classes.size() < 2) return;
    std::vector<std::pair<Rank, HalfClass>> ranked;
    for (const HalfClass& c : classes) ranked.emplace_back(rank_of(c), c);
    std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
      if (a.first.size != b.first.size) return a.first.size > b.first.size;
      if (a.first.smallest != b.first.smallest) return a.first.smallest < b.first.smallest;
      return a.first.positive && !b.first.positive;
    });
    for (std::size_t i = 0; i < classes.size(); ++i) classes[i] = ranked[i].second;
  }

  Rank rank_of(const HalfClass& c) const {
    FacetId smallest = *begin(c);
    Corners corners = sorted_corners(smallest);
    for (auto f = begin(c) + 1; f != end(c); ++f) {
      const Corners other = sorted_corners(*f);
      if (other < corners || (other == corners && sees_positive_side(*f))) {
        smallest = *f;
        corners = other;
      }
    }
    return {c.size(), corners, sees_positive_side(smallest)};
  }

  Corners sorted_corners(FacetId f) const {
    const auto [a, b, c] = triangulation_.facet_vertices(f);
    Corners corners{triangulation_.point(a), triangulation_.point(b), triangulation_.point(c)};
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  // Does the half-facet lie on the side to which the normal of its sorted corners points?
  bool sees_positive_side(FacetId f) const {
    std::array<VertexId, 3> v = triangulation_.facet_vertices(f);  // normal away from the side
    const auto less = [&](VertexId a, VertexId b) {
      return triangulation_.point(a) < triangulation_.point(b);
    };
    std::rotate(v.begin(), std::min_element(v.begin(), v.end(), less), v.end());
    return less(v[2], v[1]);
  }

  std::vector<FacetId>::const_iterator begin(const HalfClass& c) const {
    return members_.begin() + static_cast<std::ptrdiff_t>(c.begin);
  }
  std::vector<FacetId>::const_iterator end(const HalfClass& c) const {
    return members_.begin() + static_cast<std::ptrdiff_t>(c.end);
  }

  const Triangulation& triangulation_;
  const FacetSet& candidates_;
  const VertexSet& umbrella_;
  HalfFacetIndex index_;
  std::vector<std::uint32_t> class_of_;  // per half-facet
  std::vector<FacetId> members_;         // class after class
  std::size_t num_classes_ = 0;
  FacetSet kept_;
  VertexSet on_surface_;
  ManifoldSurface result_;
};

}  // namespace

ManifoldSurface extract_manifold(const Triangulation& triangulation, const FacetSet& candidates,
                                 const VertexSet& umbrella, const Execution& execution) {
  report_progress(execution, "extract_manifold", 0);
  ManifoldSurface surface = Extraction(triangulation, candidates, umbrella).run();
  report_progress(execution, "extract_manifold", 1);
  return surface;
}

}  // namespace cocoon
