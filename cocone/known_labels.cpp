#include "cocone/known_labels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/facets/half_star.h"
#include "cocone/inputs/stage_inputs.h"
#include "cocone/marking/old_triangles.h"
#include "geom/parallel/parallel_list.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

class Telling {
 public:
  Telling(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
          const FacetSet& surface, const Execution& execution)
      : triangulation_(triangulation),
        triangles_(triangles),
        surface_(surface),
        execution_(execution),
        old_(triangulation, triangles, execution),
        at_(triangulation.num_vertices(), 0) {}

  KnownLabels run() {
    find_facets();
    find_intact();
    if (any_missing_) find_undisturbed();
    if (!tell_at_once()) tell_by_vertices();
    return labels();
  }

 private:
  enum AtVertex : std::uint8_t {
    corner = 1,
    intact = 2,
    missing = 4,
    closed = 8,
    undisturbed = 16
  };
  using Found = OldTriangles::Found;

  // The old triangles that are facets: most of them are likely ones.
  void find_facets() {
    find_facets([&](std::size_t begin, std::size_t end, std::vector<Found>& found) {
      surface_.for_each(triangulation_, begin, end, [&](FacetId f) { old_.find(f, found); });
    });
    if (list_corners_of_missing()) {
      find_facets([&](std::size_t begin, std::size_t end, std::vector<Found>& found) {
        for (CellId c(begin); c.index() < end; ++c) list_missing_triangles(c, found);
      });
      any_missing_ = list_corners_of_missing();
    }
  }

  // find(begin, end, found): among the facets of these cells.
  template <class Find>
  void find_facets(const Find& find) {
    const std::size_t cells = triangulation_.num_finite_cells();
    for (const Found& found : parallel_list<Found>(execution_, cells, coarse_grain(cells), find)) {
      old_.enter(found);
    }
  }

  // Of those that have not been found. False if there are none.
  bool list_corners_of_missing() {
    bool any = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!old_.facet(t).is_none()) continue;
      for (const PointId p : triangles_[t]) at_[triangulation_.vertex_of_point()[p]] = missing;
      any = true;
    }
    return any;
  }

  void list_missing_triangles(CellId c, std::vector<Found>& found) const {
    const Cell& cell = triangulation_.cell(c);
    const unsigned corners = vertices_with(missing, cell);
    if (std::popcount(corners) < 3) return;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const bool has_corners = (corners | 1U << i) == 15U;
      if (has_corners && f < triangulation_.mirror(f) && !surface_.contains(f)) {
        old_.find(f, found);
      }
    }
  }

  void find_intact() {
    const std::size_t count = at_.size();
    parallel_chunks(execution_, count, coarse_grain(count),
                    [&](std::size_t begin, std::size_t end) {
                      for (VertexId v(begin); v.index() < end; ++v) {
                        at_[v] = static_cast<std::uint8_t>((old_.is_corner(v) ? corner : 0) |
                                                           (old_.is_intact(v) ? intact : 0));
                      }
                    });
  }

  void find_undisturbed() {
    IdVector<VertexId, std::uint8_t> beside_new(at_.size(), 0);
    for (const CellId c : triangulation_.finite_cells()) {
      const Cell& cell = triangulation_.cell(c);
      if (vertices_with(corner, cell) == 15) continue;
      for (const VertexId v : cell.vertices) beside_new[v] = 1;
    }
    for (const VertexId v : triangulation_.vertices()) {
      if ((at_[v] & intact) != 0 || !old_.is_closed(v)) continue;
      const unsigned flags = beside_new[v] == 0 ? closed | undisturbed : closed;
      at_[v] = static_cast<std::uint8_t>(at_[v] | flags);
    }
  }

  // Bit i: vertex i of the cell has this flag.
  unsigned vertices_with(unsigned flag, const Cell& cell) const {
    unsigned found = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId v = cell.vertices[i];
      if (v != infinite_vertex && (at_[v] & flag) != 0) found |= 1U << i;
    }
    return found;
  }

  bool is_undisturbed(const Cell& cell) const {
    return vertices_with(undisturbed, cell) != 0 && vertices_with(closed | intact, cell) == 15;
  }

  // If no cell is told both. Then two cells at an intact vertex, with a facet there between them
  // that is no old triangle, are told the same. So what is told goes from cell to cell, once
  // through each; and if it never meets what was told otherwise, each intact vertex has told just
  // that.
  bool tell_at_once() {
    told_ = IdVector<CellId, std::uint8_t>(triangulation_.num_cells(), 0);
    for (std::size_t t = 0; t < old_.size(); ++t) {
      const FacetId f = old_.facet(t);
      if (f.is_none() || !has_intact_vertex(f)) continue;
      const CellId behind = cell_of(f);
      const CellId before = cell_of(triangulation_.mirror(f));
      told_[behind] = static_cast<std::uint8_t>(told_[behind] | told_in);
      told_[before] = static_cast<std::uint8_t>(told_[before] | told_out);
    }
    pass_on();
    return std::none_of(told_.begin(), told_.end(), [](std::uint8_t t) { return t == told_both; });
  }

  bool has_intact_vertex(FacetId f) const {
    const auto [x, y, z] = triangulation_.facet_vertices(f);
    return ((at_[x] | at_[y] | at_[z]) & intact) != 0;
  }

  // Each cell that is told passes it on once: in the order of memory, and in the end those that
  // were told when their turn was over.
  void pass_on() {
    std::vector<CellId> late;
    for (const CellId c : triangulation_.cells()) {
      if (told_[c] != 0) pass_on_from(c, c, late);
    }
    const CellId end(triangulation_.num_cells());
    while (!late.empty()) {
      const CellId c = late.back();
      late.pop_back();
      pass_on_from(c, end, late);
    }
  }

  // Appends those before `turn` that had not been told anything. No branch depends on what a cell
  // was told.
  void pass_on_from(CellId c, CellId turn, std::vector<CellId>& late) {
    const Cell& cell = triangulation_.cell(c);
    const unsigned intact_ones = vertices_with(intact, cell);
    const unsigned told = told_[c];
    std::array<CellId, 4> news;
    std::size_t count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const bool is_old = ((unsigned{old_.facets().bits(c)} >> i) & 1U) != 0;
      const bool is_passed = !is_old && (intact_ones & ~(1U << i)) != 0;
      const CellId behind = cell_of(cell.neighbors[i]);
      const unsigned before = told_[behind];
      told_[behind] = static_cast<std::uint8_t>(before | (is_passed ? told : 0U));
      news[count] = behind;
      count += is_passed && before == 0 && behind < turn ? 1U : 0U;
    }
    late.insert(late.end(), news.begin(), news.begin() + static_cast<std::ptrdiff_t>(count));
  }

  void tell_by_vertices() {
    told_ = IdVector<CellId, std::uint8_t>(triangulation_.num_cells(), 0);
    HalfStar half(triangulation_, old_.facets());
    for (const VertexId v : triangulation_.vertices()) {
      if ((at_[v] & intact) == 0) continue;
      old_.tell_around(v, told_in, half, told_);
      old_.tell_around(v, told_out, half, told_);
    }
  }

  KnownLabels labels() const {
    KnownLabels known;
    known.labels = IdVector<CellId, CellLabel>(triangulation_.num_cells(), CellLabel::unmarked);
    for (const CellId c : triangulation_.finite_cells()) {
      if (told_[c] == told_both) ++known.contradictions;
      const CellLabel label = label_told(told_[c]);
      const Cell& cell = triangulation_.cell(c);
      if (any_missing_ && is_undisturbed(cell)) known.undisturbed.push_back(c);
      if (label == CellLabel::unmarked) continue;
      if (!is_believed(vertices_with(corner, cell), vertices_with(intact, cell))) continue;
      known.labels[c] = label;
      ++known.cells;
    }
    return known;
  }

  const Triangulation& triangulation_;
  std::span<const KnownTriangle> triangles_;
  const FacetSet& surface_;
  const Execution& execution_;
  OldTriangles old_;
  IdVector<VertexId, std::uint8_t> at_;  // flags
  IdVector<CellId, std::uint8_t> told_;
  bool any_missing_ = false;  // of the triangles: no facets
};

}  // namespace

KnownLabels known_labels(const Triangulation& triangulation,
                         std::span<const KnownTriangle> triangles, const FacetSet& surface,
                         const Execution& execution) {
  require_facets("known_labels", triangulation, surface);
  if (triangles.empty()) return {};
  return Telling(triangulation, triangles, surface, execution).run();
}

}  // namespace cocoon
