// Sides known from old triangles (cocone/known_labels.h), by their definition.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cocone/known_labels.h"
#include "delaunay/circulate.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// The definition, word by word: each intact vertex by itself.
class PlainLabels {
 public:
  PlainLabels(const Triangulation& triangulation, const std::vector<KnownTriangle>& triangles)
      : triangulation_(triangulation), told_(triangulation.num_cells()) {
    for (const KnownTriangle& t : triangles) {
      Triangle corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = triangulation.vertex_of_point()[t[k]];
      ++count_[turned_to_smallest(corners)];
      is_corner_.insert(corners.begin(), corners.end());
    }
    for (const VertexId v : is_corner_) {
      if (is_intact(v)) tell(v);
    }
  }

  KnownLabels labels() const {
    KnownLabels known;
    known.labels.resize(triangulation_.num_cells(), CellLabel::unmarked);
    for (const CellId c : triangulation_.finite_cells()) {
      known.contradictions += told_[c] == std::pair(true, true) ? 1U : 0U;
      std::size_t corners = 0;
      std::size_t intact = 0;
      for (const VertexId v : triangulation_.cell(c).vertices) {
        corners += is_corner_.contains(v) ? 1U : 0U;
        intact += is_corner_.contains(v) && is_intact(v) ? 1U : 0U;
      }
      if (told_[c].first == told_[c].second || (corners < 4 && intact < corners)) continue;
      known.labels[c] = told_[c].first ? CellLabel::in : CellLabel::out;
      ++known.cells;
    }
    return known;
  }

 private:
  using Corners = Triangle;

  static Corners turned_to_smallest(Corners t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }
  // How often the facet of the finite cell is a triangle that the cell is behind of.
  int count(FacetId f) const {
    if (triangulation_.is_infinite(cell_of(f))) return 0;
    const auto found = count_.find(turned_to_smallest(triangulation_.facet_vertices(f)));
    return found == count_.end() ? 0 : found->second;
  }
  std::vector<FacetId> facets_at(VertexId v) const {
    std::vector<FacetId> facets;
    for (const CellId c : triangulation_.cells()) {
      if (!has_vertex(triangulation_.cell(c), v)) continue;
      for (int i = 0; i < 4; ++i) {
        if (triangulation_.vertex(c, i) != v) facets.push_back(facet_id(c, i));
      }
    }
    return facets;
  }

  bool is_intact(VertexId v) const {
    int facets = 0;
    for (const FacetId f : facets_at(v)) {
      if (count(f) > 1) return false;
      facets += count(f);
    }
    int triangles = 0;
    std::map<VertexId, int> surplus;  // what runs to an edge at v, less what runs from it
    for (const auto& [t, times] : count_) {
      const auto at = std::find(t.begin(), t.end(), v);
      if (at == t.end()) continue;
      const auto k = static_cast<std::size_t>(at - t.begin());
      triangles += times;
      surplus[t[(k + 1) % 3]] -= times;
      surplus[t[(k + 2) % 3]] += times;
    }
    return facets == triangles && std::all_of(surplus.begin(), surplus.end(),
                                              [](const auto& entry) { return entry.second == 0; });
  }

  void tell(VertexId v) {
    const std::vector<FacetId> facets = facets_at(v);
    for (const FacetId f : facets) {
      if (count(f) == 0) continue;
      flood(facets, cell_of(f), &std::pair<bool, bool>::first);
      flood(facets, cell_of(triangulation_.mirror(f)), &std::pair<bool, bool>::second);
    }
  }

  // From a cell over these facets, but for triangles.
  void flood(const std::vector<FacetId>& facets, CellId first, bool std::pair<bool, bool>::*side) {
    std::set<CellId> reached = {first};
    for (std::size_t before = 0; before != reached.size();) {
      before = reached.size();
      for (const FacetId f : facets) {
        const FacetId mirror = triangulation_.mirror(f);
        if (reached.contains(cell_of(f)) && count(f) + count(mirror) == 0) {
          reached.insert(cell_of(mirror));
        }
      }
    }
    for (const CellId c : reached) told_[c].*side = true;
  }

  const Triangulation& triangulation_;
  std::map<Corners, int> count_;
  std::set<VertexId> is_corner_;
  IdVector<CellId, std::pair<bool, bool>> told_;  // IN, OUT
};

}  // namespace cocoon
