#include "cocone/marking/disputed_marks.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "cocone/facets/half_star.h"
#include "cocone/marking/half_labels.h"
#include "delaunay/star_cache.h"
#include "geom/arrays/sort_ids.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {
namespace {

using Round = std::uint32_t;
constexpr Round never = std::numeric_limits<Round>::max();

class Disputes {
 public:
  Disputes(const Triangulation& triangulation, const LinkedFacets& surface,
           const IdVector<VertexId, Halfedge>& corner_at, const CarriedMarks& carried,
           const IdVector<CellId, CellLabel>& known, CellMarks& marks, const Execution& execution)
      : triangulation_(triangulation),
        surface_(surface),
        corner_at_(corner_at),
        carried_(carried),
        known_(known),
        marks_(marks),
        stars_(triangulation, execution),
        half_star_(triangulation, surface.set),
        turn_(triangulation.num_vertices(), 0),
        half_of_(triangulation.num_vertices()),
        decisions_(triangulation.num_vertices()),
        settled_(triangulation.num_cells()) {}

  void run(std::span<const VertexId> seeds) {
    find_turns(seeds);
    suspects_.resize(marks_.rounds + 1);
    cells_.resize(marks_.rounds + 1);
    for (const VertexId v : carried_.disputed) find_half(v);
    take_known_labels();
    for (const VertexId v : carried_.disputed) {
      for (const CellId c : stars_.star(v)) {
        if (turn_of(c) == 0) {
          suspect_vertices(c);
        } else {
          cells_[turn_of(c)].push_back(c);
        }
      }
    }
    for (Round round = 1; round <= marks_.rounds; ++round) {
      make_set(suspects_[round]);
      for (const VertexId v : suspects_[round]) decide(v);
      make_set(cells_[round]);
      for (const CellId c : cells_[round]) settle(c);
    }
    for (const CellId c : changed_) marks_.labels[c] = settled_[c];
  }

 private:
  // What a vertex gives the halves of its star that should be OUT and IN.
  struct Decision {
    CellLabel of_out;
    CellLabel of_in;  // both unmarked: as it should be
  };

  // The round in which each visited vertex has its turn.
  void find_turns(std::span<const VertexId> seeds) {
    std::vector<VertexId> frontier;
    const auto visit = [&](VertexId v, Round round, std::vector<VertexId>& to) {
      if (marks_.good[v] == 0 || turn_[v] != 0) return;
      turn_[v] = round;
      to.push_back(v);
    };
    for (const VertexId v : seeds) visit(v, 1, frontier);
    std::vector<VertexId> next;
    for (Round round = 1; !frontier.empty(); ++round) {
      marks_.rounds = round;
      next.clear();
      for (const VertexId v : frontier) {
        for_each_triangle_around(surface_, corner_at_[v], [&](std::uint32_t t) {
          for (const VertexId w : surface_.corners[t]) visit(w, round + 1, next);
        });
      }
      std::swap(frontier, next);
    }
  }

  void take_known_labels() {
    for (const CellId c : known_.ids()) {
      if (known_[c] == CellLabel::unmarked || known_[c] == marks_.labels[c]) continue;
      settled_[c] = known_[c];
      changed_.push_back(c);
      suspect_vertices(c);
    }
  }

  // The round in which a cell gets its label; 0: before all rounds.
  Round turn_of(CellId c) const {
    if (triangulation_.is_infinite(c)) return 0;
    if (!known_.empty() && known_[c] != CellLabel::unmarked) return 0;
    Round first = never;
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (turn_[v] != 0) first = std::min(first, turn_[v]);
    }
    return first;
  }

  // The cells of a disputed star that should be OUT: those on that side of one of its triangles.
  void find_half(VertexId v) {
    const std::uint32_t t = triangle_of_halfedge(corner_at_[v]);
    const bool here = carried_.out_side[t] == 0;
    const std::span<const CellId> half =
        half_star_.flood(v, cell_of(here ? surface_.facets[t] : surface_.mirrors[t]));
    halves_.emplace_back(half.begin(), half.end());
    std::sort(halves_.back().begin(), halves_.back().end());
    half_of_[v] = static_cast<std::uint32_t>(halves_.size());
  }

  // Should the cell be OUT, as the side carried to its visited vertex v wants?
  bool should_be_out(VertexId v, CellId c) const {
    if (half_of_[v] == 0) return marks_.labels[c] == CellLabel::out;
    const std::vector<CellId>& half = halves_[half_of_[v] - 1];
    return std::binary_search(half.begin(), half.end(), c);
  }

  CellLabel label(CellId c) const {
    return settled_[c] != CellLabel::unmarked ? settled_[c] : marks_.labels[c];
  }

  // Those whose turn comes later and who would have the cell otherwise.
  void suspect_vertices(CellId c) {
    const Round turn = turn_of(c);
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (v == infinite_vertex || turn_[v] <= turn) continue;
      if (should_be_out(v, c) != (label(c) == CellLabel::out)) suspects_[turn_[v]].push_back(v);
    }
  }

  // As MarkingRounds does.
  void decide(VertexId v) {
    LabelCount out;
    LabelCount in;
    bool complete = true;
    for (const CellId c : stars_.star(v)) {
      if (turn_of(c) < turn_[v]) {
        (should_be_out(v, c) ? out : in).add(label(c));
      } else {
        complete = false;
      }
    }
    if (complete) return;
    const HalfLabels labels = label_halves(out, in);
    marks_.conflicts += labels.conflict ? 1U : 0U;
    if (labels.first == CellLabel::out && labels.second == CellLabel::in) return;
    decisions_[v] = {labels.first, labels.second};
    for (const CellId c : stars_.star(v)) {
      if (turn_of(c) == turn_[v]) cells_[turn_[v]].push_back(c);
    }
  }

  // What the vertices tell the cell whose turn it is.
  void settle(CellId c) {
    const Round turn = turn_of(c);
    LabelCount count;
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (turn_[v] != turn) continue;
      const bool should = should_be_out(v, c);
      CellLabel told = should ? decisions_[v].of_out : decisions_[v].of_in;
      if (told == CellLabel::unmarked) told = should ? CellLabel::out : CellLabel::in;
      count.add(told);
    }
    marks_.conflicts += count.mixed() ? 1U : 0U;
    const CellLabel label = count.majority();
    if (label != marks_.labels[c]) {
      settled_[c] = label;
      changed_.push_back(c);
    }
    suspect_vertices(c);
  }

  const Triangulation& triangulation_;
  const LinkedFacets& surface_;
  const IdVector<VertexId, Halfedge>& corner_at_;
  const CarriedMarks& carried_;
  const IdVector<CellId, CellLabel>& known_;
  CellMarks& marks_;  // its labels stay those carried to the end
  StarCache stars_;
  HalfStar half_star_;
  IdVector<VertexId, Round> turn_;                // 0: never
  ZeroedArray<VertexId, std::uint32_t> half_of_;  // of disputed vertices: 1 + position in halves_
  std::deque<std::vector<CellId>> halves_;        // sorted
  ZeroedArray<VertexId, Decision> decisions_;
  ZeroedArray<CellId, CellLabel> settled_;  // where it is not the one carried
  std::vector<CellId> changed_;
  std::vector<std::vector<VertexId>> suspects_;  // to be asked, by round
  std::vector<std::vector<CellId>> cells_;       // to be settled, by round
};

}  // namespace

void settle_disputes(const Triangulation& triangulation, const LinkedFacets& surface,
                     const IdVector<VertexId, Halfedge>& corner_at, const CarriedMarks& carried,
                     std::span<const VertexId> seeds, const IdVector<CellId, CellLabel>& known,
                     CellMarks& marks, const Execution& execution) {
  Disputes(triangulation, surface, corner_at, carried, known, marks, execution).run(seeds);
}

}  // namespace cocoon
