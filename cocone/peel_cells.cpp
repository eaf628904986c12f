#include "cocone/peel_cells.h"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "cocone/clean_up/kept_reach.h"
#include "cocone/facets/facet_size.h"
#include "cocone/inputs/stage_inputs.h"
#include "cocone/marking/known_hollows.h"
#include "cocone/marking/marking_rounds.h"
#include "cocone/samples/shared_flags.h"
#include "geom/arrays/visit_where.h"

namespace cocoon {
namespace {

struct DeferredSeed {
  FacetSize size;
  FacetId facet;  // seen from the deferred cell

  // For a max-heap: larger circle first, then lexicographically smaller corners.
  friend bool operator<(const DeferredSeed& a, const DeferredSeed& b) {
    if (a.size.squared_circumradius != b.size.squared_circumradius) {
      return a.size.squared_circumradius < b.size.squared_circumradius;
    }
    return b.size.corners < a.size.corners;
  }
};

class Peeling {
 public:
  Peeling(const Triangulation& triangulation, const FacetSet& surface, CellMarks& marks,
          const Execution& execution)
      : triangulation_(triangulation),
        surface_(surface),
        marks_(marks),
        rounds_(triangulation, surface, marks, execution),
        poor_(triangulation.num_cells()),
        stops_(triangulation.num_cells()) {}

  void run(const PeelOptions& options) {
    marks_.reached = IdVector<CellId, std::uint8_t>(triangulation_.num_cells(), 0);
    marks_.poor_cells += find_poor_cells();
    if (marks_.rounds == 0) {
      reach_marked_cells();
    } else {
      for (const CellId c : triangulation_.infinite_cells()) reach(c);
    }
    close();
    if (options.deferred_seeding) {
      while (plant_deferred_seed()) close();
    } else {
      demote_unvisited();
      close();
    }
  }

  void open_cavities() {
    for (const CellId c : triangulation_.finite_cells()) {
      if (marks_.reached[c] != 0) {
        marks_.labels[c] = CellLabel::out;
      } else if (marks_.labels[c] == CellLabel::out) {
        marks_.labels[c] = CellLabel::in;
      }
    }
    find_poor_cells();  // the peel has counted them
    reach_known_cavities();
    close();
    while (mark_from_inside()) close();
  }

 private:
  // Returns how many more there are. Cells with a label have a vertex that gave it, or were poor
  // before.
  std::size_t find_poor_cells() {
    std::size_t found = 0;
    visit_unmarked([&](CellId c) {
      if (poor_[c] != 0 || triangulation_.is_infinite(c)) return;
      if (!is_poor(triangulation_, marks_.good, c)) return;
      poor_[c] = 1;
      ++found;
      FacetId smallest = facet_id(c, 0);
      FacetSize size = size_of_facet(triangulation_, smallest);
      for (int i = 1; i < 4; ++i) {
        FacetSize other = size_of_facet(triangulation_, facet_id(c, i));
        if (!(other < size)) continue;
        size = other;
        smallest = facet_id(c, i);
      }
      stops_.insert(triangulation_, smallest);
    });
    return found;
  }

  template <class Visit>
  void visit_unmarked(const Visit& visit) const {
    const std::vector<CellLabel>& labels = marks_.labels.raw();
    visit_where(
        labels.size(), [&](std::size_t c) { return labels[c] == CellLabel::unmarked; },
        [&](std::size_t c) { visit(CellId(c)); });
  }

  void reach_known_cavities() {
    if (marks_.known.empty()) return;
    for (const CellId c : known_hollow_cells(triangulation_, marks_.known, marks_.reached)) {
      reach(c);
    }
  }

  void reach(CellId c) {
    marks_.reached[c] = 1;
    marks_.labels[c] = CellLabel::out;
    stack_.push_back(c);
  }

  // Labels that came without rounds lead from each OUT cell to infinity through OUT cells. The
  // flood goes on from those with an unmarked neighbor, or with a good vertex that had no turn.
  void reach_marked_cells() {
    const bool all_visited = marks_.visited_vertices == marks_.good_vertices;
    // Which cells are OUT cannot be foreseen: no branch depends on it.
    for (const CellId c : marks_.labels.ids()) {
      marks_.reached[c] = marks_.labels[c] == CellLabel::out ? 1 : 0;
    }
    if (!all_visited) {
      for (const CellId c : triangulation_.cells()) {
        if (marks_.reached[c] != 0 && has_unvisited_vertex(c)) stack_.push_back(c);
      }
    }
    visit_unmarked([&](CellId c) {
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation_.neighbor(c, i);
        if (marks_.labels[behind] == CellLabel::out) stack_.push_back(behind);
      }
    });
  }

  bool has_unvisited_vertex(CellId c) const {
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (v != infinite_vertex && is_unvisited(marks_, v)) return true;
    }
    return false;
  }

  // May the peel go through facet f (seen from a reached cell) into the cell behind it?
  bool may_cross(FacetId f, CellId behind) const {
    switch (marks_.labels[behind]) {
      case CellLabel::out:
        return true;
      case CellLabel::in:
        return false;
      case CellLabel::unmarked:
        break;
    }
    return poor_[behind] != 0 && !stops_.contains(f);
  }

  // Reaches whatever can be reached with the labels as they are.
  void flood() {
    const bool all_visited = marks_.visited_vertices == marks_.good_vertices;
    while (!stack_.empty()) {
      const CellId c = stack_.back();
      stack_.pop_back();
      if (!all_visited) list_seeds(c);
      for (int i = 0; i < 4; ++i) {
        const FacetId mirror = triangulation_.mirror(facet_id(c, i));
        const CellId behind = cell_of(mirror);
        if (marks_.reached[behind] != 0) continue;
        if (may_cross(facet_id(c, i), behind)) {
          reach(behind);
        } else if (is_deferred(behind) && !surface_.contains(mirror)) {
          deferred_.push_back(mirror);
        }
      }
    }
  }

  // Good vertices that had no turn.
  void list_seeds(CellId c) {
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (v != infinite_vertex && is_unvisited(marks_, v)) seeds_.push_back(v);
    }
  }

  // Its good vertices had no turn.
  bool is_deferred(CellId c) const {
    return marks_.reached[c] == 0 && marks_.labels[c] == CellLabel::unmarked && poor_[c] == 0;
  }

  // Floods and marks in turn until nothing changes.
  void close() {
    for (flood(); !seeds_.empty(); flood()) {
      std::vector<CellId> out_cells;
      rounds_.run(seeds_, out_cells);
      seeds_.clear();
      for (const CellId c : out_cells) {
        if (marks_.reached[c] == 0 && touches_reached(c)) reach(c);
      }
    }
  }

  bool touches_reached(CellId c) const {
    for (int i = 0; i < 4; ++i) {
      if (marks_.reached[triangulation_.neighbor(c, i)] != 0) return true;
    }
    return false;
  }

  // The turn of the good vertices that had none and touch a cell known to be IN. False if there is
  // no such vertex.
  bool mark_from_inside() {
    std::vector<VertexId> inner;
    for (const CellId c : triangulation_.finite_cells()) {
      if (marks_.labels[c] != CellLabel::in) continue;
      for (const VertexId v : triangulation_.cell(c).vertices) {
        if (is_unvisited(marks_, v)) inner.push_back(v);
      }
    }
    std::vector<CellId> out_cells;
    rounds_.run(inner, out_cells);
    for (const CellId c : out_cells) {
      if (marks_.reached[c] == 0) reach(c);
    }
    return !inner.empty();
  }

  // False if no deferred cell lies next to a reached one.
  bool plant_deferred_seed() {
    for (const FacetId f : deferred_) {
      if (is_deferred(cell_of(f))) heap_.push({size_of_facet(triangulation_, f), f});
    }
    deferred_.clear();
    while (!heap_.empty()) {
      const CellId c = cell_of(heap_.top().facet);
      heap_.pop();
      if (!is_deferred(c)) continue;
      ++marks_.deferred_seeds;
      reach(c);
      return true;
    }
    return false;
  }

  // The paper's second pass: surface that the marking did not reach is treated as rubble.
  void demote_unvisited() {
    for (const VertexId v : triangulation_.vertices()) marks_.good[v] &= marks_.visited[v];
    marks_.poor_cells += find_poor_cells();
    // look again into every poor cell next to a reached one
    for (const CellId c : triangulation_.finite_cells()) {
      if (marks_.reached[c] != 0 || poor_[c] == 0) continue;
      for (int i = 0; i < 4 && marks_.reached[c] == 0; ++i) {
        const FacetId from = triangulation_.mirror(facet_id(c, i));
        if (marks_.reached[cell_of(from)] != 0 && may_cross(from, c)) reach(c);
      }
    }
  }

  const Triangulation& triangulation_;
  const FacetSet& surface_;
  CellMarks& marks_;
  MarkingRounds rounds_;
  ZeroedArray<CellId, std::uint8_t> poor_;
  FacetSet stops_;
  std::vector<CellId> stack_;
  std::vector<VertexId> seeds_;
  std::vector<FacetId> deferred_;  // seen from the deferred cell
  std::priority_queue<DeferredSeed> heap_;
};

// Good vertices at facets of the surface with both sides alike, and at others with different ones.
VertexSet contradicted_vertices(const Triangulation& triangulation, const FacetSet& surface,
                                const CellMarks& marks, const Execution& execution) {
  constexpr std::size_t cells_per_chunk = std::size_t{1} << 14;
  SharedFlags contradicted(triangulation.num_vertices());
  const auto is_out = [&](CellId c) { return marks.labels[c] == CellLabel::out; };
  parallel_chunks(execution, triangulation.num_cells(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (CellId c(begin); c.index() < end; ++c) {
                      for (int i = 0; i < 4; ++i) {
                        const FacetId f = facet_id(c, i);
                        const bool differ = is_out(c) != is_out(triangulation.neighbor(c, i));
                        if (differ == surface.contains(f)) continue;
                        for (const VertexId v : triangulation.facet_vertices(f)) {
                          if (v != infinite_vertex && marks.good[v] != 0) contradicted.raise(v);
                        }
                      }
                    }
                  });
  return std::move(contradicted).take();
}

// What hangs together by facets.
CavityCounters count_parts(const Triangulation& triangulation,
                           IdVector<CellId, std::uint8_t> cells) {
  CavityCounters count;
  std::vector<CellId> stack;
  for (const CellId first : cells.ids()) {
    if (cells[first] == 0) continue;
    ++count.cavities;
    cells[first] = 0;
    for (stack.assign(1, first); !stack.empty(); ++count.cells) {
      const CellId c = stack.back();
      stack.pop_back();
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation.neighbor(c, i);
        if (cells[behind] == 0) continue;
        cells[behind] = 0;
        stack.push_back(behind);
      }
    }
  }
  return count;
}

}  // namespace

CellMarks peel_cells(const Triangulation& triangulation, const FacetSet& surface, CellMarks marks,
                     const PeelOptions& options, const Execution& execution) {
  require_facets("peel_cells", triangulation, surface);
  require_marked("peel_cells", triangulation, marks);
  report_progress(execution, "peel_cells", 0);
  Peeling(triangulation, surface, marks, execution).run(options);
  if (marks.conflicts != 0) {
    marks.contradicted = contradicted_vertices(triangulation, surface, marks, execution);
  }
  report_progress(execution, "peel_cells", 1);
  return marks;
}

CavityCounters open_cavities(const Triangulation& triangulation, const FacetSet& surface,
                             CellMarks& marks, const Execution& execution) {
  require_facets("open_cavities", triangulation, surface);
  require_marked("open_cavities", triangulation, marks);
  require_peeled("open_cavities", triangulation, marks);
  // Known hollows may be open already.
  const IdVector<CellId, std::uint8_t> before =
      marks.known.empty() ? marks.reached : reached_from_infinity(triangulation, marks.reached);
  Peeling(triangulation, surface, marks, execution).open_cavities();
  IdVector<CellId, std::uint8_t> hollow(before.size(), 0);
  for (const CellId c : hollow.ids()) hollow[c] = marks.reached[c] != 0 && before[c] == 0;
  return count_parts(triangulation, std::move(hollow));
}

}  // namespace cocoon
