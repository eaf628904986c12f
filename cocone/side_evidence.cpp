#include "cocone/side_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>

#include "delaunay/circulate.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 4>;

Corners sorted_corners(const Triangulation& triangulation, CellId c) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    corners[static_cast<std::size_t>(i)] = triangulation.point(triangulation.vertex(c, i));
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

struct Turn {
  float clarity;
  std::uint32_t rank;  // in canonical order
  CellId cell;

  friend bool operator<(const Turn& a, const Turn& b) {
    return a.clarity != b.clarity ? a.clarity < b.clarity : a.rank > b.rank;
  }
};

// The finite cells of a star with the poles of its vertex; none at infinity.
struct PolePair {
  CellId positive;
  CellId negative;
};

class Propagation {
 public:
  Propagation(const Triangulation& triangulation, const Dual& dual, StarCache& stars,
              const Poles& poles, const CellMarks& marks, const std::vector<CellId>& undecided)
      : triangulation_(triangulation),
        dual_(dual),
        stars_(stars),
        poles_(poles),
        evidence_(triangulation.num_cells()),
        state_(triangulation.num_cells()) {
    rank(undecided);
    find_domain(undecided);
    settle_known(marks);
  }

  ZeroedArray<CellId, SideEvidence> run() {
    while (!turns_.empty()) {
      const Turn turn = turns_.top();
      turns_.pop();
      if (state_[turn.cell] != open || turn.clarity != clarity(turn.cell)) continue;
      state_[turn.cell] = closed;
      const SideEvidence& e = evidence_[turn.cell];
      pass_on(turn.cell, e.out >= e.in, std::max(e.out, e.in));
    }
    return std::move(evidence_);
  }

 private:
  // settled: not asked about. open, closed: undecided cells before and after their turn.
  enum State : std::uint8_t { settled = 0, open, closed };

  void rank(const std::vector<CellId>& undecided) {
    std::vector<std::pair<Corners, CellId>> order;
    order.reserve(undecided.size());
    for (const CellId c : undecided) order.emplace_back(sorted_corners(triangulation_, c), c);
    std::sort(order.begin(), order.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    ranks_ = ZeroedArray<CellId, std::uint32_t>(triangulation_.num_cells());
    std::uint32_t next = 0;
    for (const auto& [corners, c] : order) ranks_[c] = next++;
  }

  void find_domain(const std::vector<CellId>& undecided) {
    VertexSet near(triangulation_.num_vertices(), 0);
    pairs_.resize(triangulation_.num_vertices());
    for (const CellId c : undecided) {
      state_[c] = open;
      for (const VertexId v : triangulation_.cell(c).vertices) {
        if (near[v] != 0) continue;
        near[v] = 1;
        vertices_.push_back(v);
        pairs_[v] = find_poles(v);
      }
    }
  }

  PolePair find_poles(VertexId v) const {
    const Point& p = triangulation_.point(v);
    Vec3 normal = poles_.normals[v];
    PolePair pair;
    if (!is_hull_vertex(triangulation_, stars_, v)) {
      pair.positive = farthest(v, {});
      normal = dual_.centers[pair.positive] - p;
    }
    pair.negative = farthest(v, normal);
    return pair;
  }

  // Of the finite cells at v whose center lies below the normal (if there is one).
  CellId farthest(VertexId v, const Vec3& normal) const {
    const Point& p = triangulation_.point(v);
    CellId best;
    double largest = -1;
    for (const CellId c : stars_.star(v)) {
      if (triangulation_.is_infinite(c)) continue;
      const Vec3 arm = dual_.centers[c] - p;
      if (normal != Vec3{} && !(dot(arm, normal) < 0)) continue;
      const double reach = squared_norm(arm);
      if (reach < largest || (reach == largest && !precedes(c, best))) continue;
      largest = reach;
      best = c;
    }
    return best;
  }

  // Ties: the smaller center, and of cells on one sphere the smaller corners.
  bool precedes(CellId a, CellId b) const {
    if (dual_.centers[a] != dual_.centers[b]) return dual_.centers[a] < dual_.centers[b];
    return sorted_corners(triangulation_, a) < sorted_corners(triangulation_, b);
  }

  void settle_known(const CellMarks& marks) {
    ZeroedArray<CellId, std::uint8_t> told(triangulation_.num_cells());
    for (const VertexId v : vertices_) {
      for (const CellId c : stars_.star(v)) {
        if (state_[c] != settled || told[c] != 0) continue;
        told[c] = 1;
        pass_on(c, marks.labels[c] == CellLabel::out, 1);
      }
    }
  }

  float clarity(CellId c) const {
    const SideEvidence& e = evidence_[c];
    if (e.out == 0 || e.in == 0) return std::max(e.out, e.in);
    return std::abs(e.out - e.in) - 1;
  }

  void raise(CellId c, bool out, double weight) {
    if (state_[c] == settled || !(weight > 0)) return;
    float& value = out ? evidence_[c].out : evidence_[c].in;
    if (static_cast<float>(weight) <= value) return;
    value = static_cast<float>(weight);
    if (state_[c] == open) turns_.push({clarity(c), ranks_[c], c});
  }

  void pass_on(CellId c, bool out, double weight) {
    if (!triangulation_.is_infinite(c)) pass_on_to_deep_balls(c, out, weight);
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (v != infinite_vertex) pass_on_to_opposite_pole(c, v, out, weight);
    }
  }

  void pass_on_to_deep_balls(CellId c, bool out, double weight) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const CellId behind = cell_of(triangulation_.mirror(f));
      if (state_[behind] == settled) continue;
      raise(behind, out, weight * contact_cosine(triangulation_, dual_, f));
    }
  }

  void pass_on_to_opposite_pole(CellId c, VertexId v, bool out, double weight) {
    const PolePair& pair = pairs_[v];
    const Point& p = triangulation_.point(v);
    Vec3 arm;
    CellId other;
    if (triangulation_.is_infinite(c)) {
      arm = poles_.normals[v];
      other = pair.negative;
    } else {
      if (pair.positive != c && pair.negative != c) return;
      arm = unit(dual_.centers[c] - p);
      other = pair.positive == c ? pair.negative : pair.positive;
    }
    if (other.is_none()) return;
    raise(other, !out, weight * -dot(unit(dual_.centers[other] - p), arm));
  }

  const Triangulation& triangulation_;
  const Dual& dual_;
  StarCache& stars_;
  const Poles& poles_;
  ZeroedArray<CellId, SideEvidence> evidence_;
  ZeroedArray<CellId, State> state_;
  ZeroedArray<CellId, std::uint32_t> ranks_;
  IdVector<VertexId, PolePair> pairs_;
  std::vector<VertexId> vertices_;  // of undecided cells
  std::priority_queue<Turn> turns_;
};

}  // namespace

double ball_cosine(const Triangulation& triangulation, const Dual& dual, FacetId f) {
  const CellId c = cell_of(f);
  if (triangulation.is_infinite(c)) return 1;
  const auto [v0, v1, v2] = triangulation.facet_vertices(f);
  std::array<Point, 3> p{triangulation.point(v0), triangulation.point(v1), triangulation.point(v2)};
  std::sort(p.begin(), p.end());
  const Vec3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
  const Point& apex = triangulation.point(triangulation.opposite_vertex(f));
  const double cosine = dot(normal, unit(dual.centers[c] - p[0]));
  const bool apex_above = dot(normal, apex - p[0]) > 0;
  return std::clamp(apex_above ? cosine : -cosine, -1.0, 1.0);
}

double contact_cosine(const Triangulation& triangulation, const Dual& dual, FacetId f) {
  // beta = pi - phi - psi: cos(beta) = -cos(phi + psi) = sin phi sin psi - cos phi cos psi
  const double phi = ball_cosine(triangulation, dual, f);
  const double psi = ball_cosine(triangulation, dual, triangulation.mirror(f));
  const double sines = std::sqrt((1 - phi * phi) * (1 - psi * psi));
  return sines - phi * psi;
}

ZeroedArray<CellId, SideEvidence> side_evidence(const Triangulation& triangulation,
                                                const Dual& dual, StarCache& stars,
                                                const Poles& poles, const CellMarks& marks,
                                                const std::vector<CellId>& undecided) {
  return Propagation(triangulation, dual, stars, poles, marks, undecided).run();
}

}  // namespace cocoon
