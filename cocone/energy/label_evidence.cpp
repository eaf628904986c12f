#include "cocone/energy/label_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/energy/turn_queue.h"
#include "cocone/facets/cell_order.h"
#include "delaunay/circulate.h"
#include "delaunay/vertices_of_cells.h"

namespace cocoon {
namespace {

// The poles of a vertex, finite cells of its star. The positive one is none on the hull: it is
// infinity.
struct PolePair {
  CellId positive;
  CellId negative;
  double trust;  // in what one of them says of the other
};

// The farthest of the cells that it is told.
struct FarthestCell {
  CellId cell;
  double reach = 0;  // squared
};

class Propagation {
 public:
  Propagation(const Triangulation& triangulation, StarCache& stars, BallCosines& cosines,
              const ZeroedArray<CellId, Point>& centers, SpacingCache& spacings, const Poles& poles,
              const CellMarks& marks, const DoubtfulRegion& region, const CleanUpOptions& options,
              const Execution& execution)
      : triangulation_(triangulation),
        stars_(stars),
        cosines_(cosines),
        poles_(poles),
        region_(region),
        centers_(centers),
        labels_(marks.labels),
        nodes_(triangulation.num_cells()),
        is_asked_(triangulation.num_vertices(), 0),
        poles_at_(triangulation.num_vertices()) {
    rank();
    find_asked();
    find_flat_cells(execution);
    find_poles(spacings, marks.good, options, execution);
    settle_known();
    credit_marks(marks, options.mark_credit);
  }

  ZeroedArray<CellId, LabelEvidence> run() {
    for (Turn turn = 0; turns_.pop(turn);) {
      ask_ahead();
      const CellId c = order_[rank_of(turn)];
      Node& node = nodes_[c];
      const LabelEvidence& e = node.evidence;
      if (node.state != open || turn != make_turn(clarity(e), node.rank)) continue;
      node.state = closed;
      pass_on(c, e.out >= e.in, std::max(e.out, e.in));
    }
    ZeroedArray<CellId, LabelEvidence> evidence(triangulation_.num_cells());
    for (const CellId c : region_.undecided) evidence[c] = nodes_[c].evidence;
    return evidence;
  }

 private:
  // settled: not asked about. open, closed: undecided cells before and after their turn.
  enum State : std::uint8_t { settled = 0, open, closed };
  // What is known of a cell, in one place: they are visited in no order of memory.
  struct Node {
    LabelEvidence evidence;
    std::uint32_t rank;  // of an undecided cell, in order_
    State state;
    bool is_flat;  // of a cell of the region
    bool is_pole;
  };

  // The canonical order of the undecided cells: by the ranks of their corners. First by the lowest,
  // by counting; few cells have the same.
  void rank() {
    struct Key {
      std::array<std::uint32_t, 4> corners;
      CellId cell;
    };
    std::vector<Key> keys;
    keys.reserve(region_.undecided.size());
    std::vector<std::uint32_t> place(region_.vertices.size() + 2, 0);
    for (const CellId c : region_.undecided) {
      Key key{{}, c};
      for (std::size_t i = 0; i < 4; ++i) {
        key.corners[i] = region_.rank[triangulation_.cell(c).vertices[i]];
      }
      std::sort(key.corners.begin(), key.corners.end());
      ++place[key.corners[0] + 1];
      keys.push_back(key);
    }
    for (std::size_t k = 1; k < place.size(); ++k) place[k] += place[k - 1];
    std::vector<Key> order(keys.size());
    for (const Key& key : keys) order[place[key.corners[0]]++] = key;
    std::uint32_t begin = 0;  // of the cells with one lowest rank
    for (const std::uint32_t end : place) {
      std::sort(order.begin() + begin, order.begin() + end,
                [](const Key& a, const Key& b) { return a.corners < b.corners; });
      begin = end;
    }
    order_.reserve(order.size());
    for (const Key& key : order) {
      nodes_[key.cell].rank = static_cast<std::uint32_t>(order_.size());
      order_.push_back(key.cell);
    }
  }

  // For what the cells that have their turn soon will read.
  void ask_ahead() const {
    constexpr std::size_t soon = 6;
    __builtin_prefetch(&order_[turns_.rank_ahead(3 * soon)]);
    const CellId later = order_[turns_.rank_ahead(2 * soon)];
    __builtin_prefetch(&nodes_[later]);
    __builtin_prefetch(&triangulation_.cell(later));
    cosines_.ask_ahead(later);
    const CellId next = order_[turns_.rank_ahead(soon)];
    for (const FacetId behind : triangulation_.cell(next).neighbors) {
      __builtin_prefetch(&nodes_[cell_of(behind)]);
      cosines_.ask_ahead(cell_of(behind));
    }
    if (!nodes_[next].is_pole) return;
    for (const VertexId v : triangulation_.cell(next).vertices) {
      if (v != infinite_vertex) __builtin_prefetch(&poles_at_[v]);
    }
  }

  void find_asked() {
    for (const CellId c : region_.undecided) nodes_[c].state = open;
    asked_ = vertices_of(triangulation_, region_.undecided);
    for (const VertexId v : asked_) is_asked_[v] = 1;
  }

  void find_flat_cells(const Execution& execution) {
    constexpr std::size_t cells_per_chunk = 4096;
    // What is known already may be asked by several threads.
    parallel_chunks(execution, region_.cells.size(), cells_per_chunk,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t k = begin; k < end; ++k) {
                        const CellId c = region_.cells[k];
                        if (cosines_.is_flat(c)) nodes_[c].is_flat = true;
                      }
                    });
  }

  const Point& center(CellId c) const { return centers_[c]; }

  template <class Visit>
  void for_asked_vertices(CellId c, Visit visit) {
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (v != infinite_vertex && is_asked_[v] != 0) visit(v);
    }
  }

  void find_poles(SpacingCache& spacings, const VertexSet& good, const CleanUpOptions& options,
                  const Execution& execution) {
    spacings.prepare(asked_, execution);  // threads may ask for known ones
    visit_stars_in_parallel(triangulation_, stars_, asked_, execution,
                            [&](VertexId v) { find_poles_at(v, spacings, good, options); });
    for (const VertexId v : asked_) {
      for (const CellId pole : {poles_at_[v].positive, poles_at_[v].negative}) {
        if (!pole.is_none()) nodes_[pole].is_pole = true;
      }
    }
  }

  // The finite cells farthest off: of all, and of those whose center lies below the normal.
  void find_poles_at(VertexId v, SpacingCache& spacings, const VertexSet& good,
                     const CleanUpOptions& options) {
    const std::span<const CellId> star = stars_.star(v);
    const Point& p = triangulation_.point(v);
    PolePair& here = poles_at_[v];
    FarthestCell farthest;
    const bool on_hull = triangulation_.is_infinite(star.back());  // infinite cells come last
    if (!on_hull) {
      for (const CellId c : star) {
        if (!nodes_[c].is_flat) raise_pole(farthest, c, center(c) - p);
      }
      if (farthest.cell.is_none()) return;  // all are flat
      here.positive = farthest.cell;
    }
    const Vec3 normal = on_hull ? poles_.normals[v] : center(here.positive) - p;
    FarthestCell below;
    for (const CellId c : star) {
      if (triangulation_.is_infinite(c) || nodes_[c].is_flat) continue;
      const Vec3 arm = center(c) - p;
      if (dot(arm, normal) < 0) raise_pole(below, c, arm);
    }
    here.negative = below.cell;
    here.trust =
        trust_in(std::sqrt(below.reach) / spacings.of(v), good_share(v, star, good), options);
  }

  static double trust_in(double ratio, double good_share, const CleanUpOptions& options) {
    const double width = options.full_pole_ratio - options.near_pole_ratio;
    const double far = ratio >= options.full_pole_ratio
                           ? 1
                           : std::max(0.0, (ratio - options.near_pole_ratio) / width);
    const double calm =
        options.pole_good_share > 0 ? std::min(1.0, good_share / options.pole_good_share) : 1;
    return far + (1 - far) * calm;
  }

  // Of the other corners of the finite cells of a star, each as often as it comes.
  double good_share(VertexId v, std::span<const CellId> star, const VertexSet& good) const {
    std::uint32_t around = 0;
    std::uint32_t good_around = 0;
    for (const CellId c : star) {
      if (triangulation_.is_infinite(c)) break;
      for (const VertexId w : triangulation_.cell(c).vertices) good_around += good[w];
      good_around -= good[v];
      around += 3;
    }
    return around == 0 ? 0 : static_cast<double>(good_around) / around;
  }

  void raise_pole(FarthestCell& farthest, CellId c, const Vec3& arm) const {
    const double squared = squared_norm(arm);
    if (!farthest.cell.is_none() &&
        (squared < farthest.reach || (squared == farthest.reach && !precedes(c, farthest.cell)))) {
      return;
    }
    farthest = {c, squared};
  }

  // Ties: the smaller center, and of cells on one sphere the smaller corners.
  bool precedes(CellId a, CellId b) const {
    if (center(a) != center(b)) return center(a) < center(b);
    return sorted_corners(triangulation_, a) < sorted_corners(triangulation_, b);
  }

  bool is_out(CellId c) const { return labels_[c] == CellLabel::out; }

  // What the known cells tell the undecided ones, these being asked: few of the others are beside
  // one, or are opposite poles.
  void settle_known() {
    for (const VertexId v : asked_) {
      for (const CellId pole : {poles_at_[v].positive, poles_at_[v].negative}) {
        if (!pole.is_none() && nodes_[pole].state == settled) {
          pass_on_to_opposite_pole(pole, v, is_out(pole), 1);
        }
      }
      const std::span<const CellId> star = stars_.star(v);
      for (auto c = star.rbegin(); c != star.rend() && triangulation_.is_infinite(*c); ++c) {
        pass_on_to_opposite_pole(*c, v, is_out(*c), 1);
      }
    }
    for (const CellId c : region_.undecided) {
      for (int i = 0; i < 4; ++i) {
        const FacetId behind = triangulation_.mirror(facet_id(c, i));
        if (nodes_[cell_of(behind)].state == settled) hear_from(behind);
      }
    }
    for (const CellId c : flat_cells_beside_undecided()) {
      for (int i = 0; i < 4; ++i) {
        const FacetId behind = triangulation_.mirror(facet_id(c, i));
        bool has_asked_vertex = false;
        for_asked_vertices(cell_of(behind), [&](VertexId) { has_asked_vertex = true; });
        if (has_asked_vertex && nodes_[cell_of(behind)].state == settled) hear_from(behind);
      }
    }
  }

  // What few good vertices say of a thin cell, if their labels are not in conflict.
  void credit_marks(const CellMarks& marks, double mark_credit) {
    if (region_.thin_cells == 0) return;
    for (const CellId c : region_.undecided) {
      const auto& vertices = triangulation_.cell(c).vertices;
      if (cosines_.is_flat(c) || is_poor(triangulation_, marks.good, c)) continue;
      const bool in_conflict = std::any_of(vertices.begin(), vertices.end(),
                                           [&](VertexId v) { return is_contradicted(marks, v); });
      if (!in_conflict) raise(c, is_out(c), mark_credit);
    }
  }

  // What its settled cell has to say across a facet.
  void hear_from(FacetId f) {
    const CellId c = cell_of(f);
    if (triangulation_.is_infinite(c) || cosines_.is_flat(c)) return;
    const CellId behind = cosines_.beyond(f);
    if (!behind.is_none()) raise_deep_ball(behind, f, is_out(c), 1);
  }

  // Through which others may be seen from undecided ones.
  std::vector<CellId> flat_cells_beside_undecided() {
    std::vector<CellId> found;
    ZeroedArray<CellId, std::uint8_t> met(triangulation_.num_cells());
    const auto meet = [&](CellId c) {
      if (!cosines_.is_flat(c) || met[c] != 0) return;
      met[c] = 1;
      found.push_back(c);
    };
    for (const CellId c : region_.undecided) {
      for (int i = 0; i < 4; ++i) meet(triangulation_.neighbor(c, i));
    }
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (int i = 0; i < 4; ++i) meet(triangulation_.neighbor(found[next], i));
    }
    return found;
  }

  static float clarity(const LabelEvidence& e) {
    if (e.out == 0 || e.in == 0) return std::max(e.out, e.in);
    return std::abs(e.out - e.in) - 1;
  }

  void raise(CellId c, bool out, double weight) {
    Node& node = nodes_[c];
    if (node.state == settled || !(weight > 0)) return;
    float& value = out ? node.evidence.out : node.evidence.in;
    if (static_cast<float>(weight) <= value) return;
    value = static_cast<float>(weight);
    if (node.state == open) turns_.push(clarity(node.evidence), node.rank);
  }

  // What an undecided cell has to say.
  void pass_on(CellId c, bool out, double weight) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const CellId next = triangulation_.neighbor(c, i);
      const CellId behind = nodes_[next].is_flat ? cosines_.beyond(f) : next;
      if (!behind.is_none()) raise_deep_ball(behind, f, out, weight);
    }
    if (!nodes_[c].is_pole) return;
    for_asked_vertices(c, [&](VertexId v) { pass_on_to_opposite_pole(c, v, out, weight); });
  }

  // Of the cell behind a facet, through flat ones.
  void raise_deep_ball(CellId behind, FacetId f, bool out, double weight) {
    if (nodes_[behind].state == settled) return;
    raise(behind, out, weight * cosines_.contact(f));
  }

  void pass_on_to_opposite_pole(CellId c, VertexId v, bool out, double weight) {
    const PolePair& pair = poles_at_[v];
    const Point& p = triangulation_.point(v);
    Vec3 arm;
    CellId other;
    if (triangulation_.is_infinite(c)) {
      arm = poles_.normals[v];
      other = pair.negative;
    } else {
      if (pair.positive != c && pair.negative != c) return;
      arm = unit(center(c) - p);
      other = pair.positive == c ? pair.negative : pair.positive;
    }
    if (other.is_none()) return;
    raise(other, !out, weight * pair.trust * -dot(unit(center(other) - p), arm));
  }

  const Triangulation& triangulation_;
  StarCache& stars_;
  BallCosines& cosines_;
  const Poles& poles_;
  const DoubtfulRegion& region_;
  const ZeroedArray<CellId, Point>& centers_;  // of the finite cells of the region
  const IdVector<CellId, CellLabel>& labels_;
  ZeroedArray<CellId, Node> nodes_;
  std::vector<CellId> order_;  // undecided cells in canonical order
  VertexSet is_asked_;         // 1: a vertex of an undecided cell
  std::vector<VertexId> asked_;
  IdVector<VertexId, PolePair> poles_at_;
  TurnQueue turns_;
};

}  // namespace

ZeroedArray<CellId, LabelEvidence> label_evidence(
    const Triangulation& triangulation, StarCache& stars, BallCosines& cosines,
    const ZeroedArray<CellId, Point>& centers, SpacingCache& spacings, const Poles& poles,
    const CellMarks& marks, const DoubtfulRegion& region, const CleanUpOptions& options,
    const Execution& execution) {
  if (region.undecided.empty()) {
    return ZeroedArray<CellId, LabelEvidence>(triangulation.num_cells());
  }
  return Propagation(triangulation, stars, cosines, centers, spacings, poles, marks, region,
                     options, execution)
      .run();
}

}  // namespace cocoon
