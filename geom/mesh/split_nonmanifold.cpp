#include "geom/mesh/split_nonmanifold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh/halfedges.h"
#include "geom/mesh/triangles_at_vertices.h"
#include "geom/orient3d.h"

namespace cocoon {
namespace {

// The angular order of half-planes around a line, exact.
class AroundLine {
 public:
  // From the half-plane through p0, counterclockwise seen from v towards u. p0 is not on the line.
  AroundLine(const Point& u, const Point& v, const Point& p0) : u_(u), v_(v), p0_(p0) {
    for (int axis = 0; axis < 3; ++axis) {
      above_ = beside(axis);
      side_of_start_ = orient3d(u_, v_, above_, p0_);
      if (side_of_start_ != Sign::zero) return;
    }
  }

  // Negative: the half-plane through p comes before that through q; zero: they are the same.
  Sign compare(const Point& p, const Point& q) const {
    const int quarter_p = quarter(p);
    const int quarter_q = quarter(q);
    if (quarter_p != quarter_q) return quarter_p < quarter_q ? Sign::negative : Sign::positive;
    return -orient3d(u_, v_, p, q);
  }

 private:
  // u moved along one axis: of any plane through u, one of the three is off it, whatever rounding
  // does to the length of the way.
  Point beside(int axis) const {
    const Vec3 to_v = v_ - u_;
    const Vec3 to_p = p0_ - u_;
    double reach = std::fabs(u_[axis]);
    for (int k = 0; k < 3; ++k) {
      reach = std::max({reach, std::fabs(to_v[k]), std::fabs(to_p[k])});
    }
    const double moved = u_[axis] - std::copysign(reach, u_[axis]);
    return {axis == 0 ? moved : u_.x, axis == 1 ? moved : u_.y, axis == 2 ? moved : u_.z};
  }

  // 0: at angle 0; 1: in (0, pi); 2: at pi; 3: in (pi, 2 pi).
  int quarter(const Point& p) const {
    const Sign side = orient3d(u_, v_, p0_, p);
    if (side != Sign::zero) return side == Sign::positive ? 1 : 3;
    return orient3d(u_, v_, above_, p) == side_of_start_ ? 0 : 2;
  }

  Point u_;
  Point v_;
  Point p0_;
  Point above_;
  Sign side_of_start_ = Sign::zero;
};

class Splitter {
 public:
  explicit Splitter(const TriangleMesh& mesh)
      : mesh_(mesh), rings_(link_halfedges(mesh)), triangles_at_(triangles_at_vertices(mesh)) {}

  SplitSurface run() {
    require_proper_triangles();
    pair_halfedges();
    copy_vertices();
    for (std::vector<Halfedge> seams = find_seams(); !seams.empty(); seams = find_seams()) {
      split_seams(seams);
    }
    canonicalize_triangles(result_.mesh);
    return std::move(result_);
  }

 private:
  using Key = std::array<Point, 3>;

  void require_proper_triangles() const {
    for (const TriangleId t : mesh_.triangles.ids()) {
      if (!repeats_a_vertex(mesh_.triangles[t])) continue;
      throw InputError("triangle " + std::to_string(t.value) +
                       " names a vertex twice; remove such triangles first");
    }
  }

  void pair(Halfedge a, Halfedge b) {
    partner_[a] = b;
    partner_[b] = a;
  }

  void pair_halfedges() {
    partner_.assign(rings_.links.size(), no_halfedge);
    for (Halfedge last = 0; last < partner_.size(); ++last) {
      if (!rings_.is_last(last)) continue;
      std::vector<Halfedge> ring;
      for_each_at_edge(rings_.links, rings_.links[last],
                       [&](Halfedge halfedge) { ring.push_back(halfedge); });
      if (ring.size() == 2) pair(ring[0], ring[1]);
      if (ring.size() < 3) continue;
      ++result_.split_edges;
      suspects_.insert(suspects_.end(), ring.begin(), ring.end());
      pair_wedges(std::move(ring));
    }
  }

  const Point& apex(Halfedge halfedge) const {
    return mesh_.points[apex_of_halfedge(mesh_, halfedge)];
  }

  // In angular order about u -> v a triangle that runs v -> u has the inside ahead, one that runs
  // u -> v has it behind: they match like brackets. Of triangles in one half-plane those that have
  // it behind come first, so that bodies that touch along a facet are two.
  void pair_wedges(std::vector<Halfedge> ring) {
    auto [u, v] = ends_of_halfedge(mesh_, ring.front());
    if (v < u) std::swap(u, v);
    if (mesh_.points[v] < mesh_.points[u]) std::swap(u, v);  // not as they happen to be numbered
    const AroundLine order(mesh_.points[u], mesh_.points[v], apex(ring.front()));
    const auto opens = [&, end = v](Halfedge halfedge) {
      return ends_of_halfedge(mesh_, halfedge)[0] == end;
    };
    std::sort(ring.begin(), ring.end(), [&](Halfedge a, Halfedge b) {
      const Point& p = apex(a);
      const Point& q = apex(b);
      if (const Sign sign = order.compare(p, q); sign != Sign::zero) return sign == Sign::negative;
      if (opens(a) != opens(b)) return opens(b);
      return p == q ? a < b : p < q;  // equal ones may stand for each other
    });
    std::vector<Halfedge> open;
    std::size_t paired = 0;
    for (std::size_t k = 0; k < 2 * ring.size(); ++k) {  // brackets may close past the start
      const Halfedge halfedge = ring[k % ring.size()];
      if (partner_[halfedge] != no_halfedge) continue;
      if (opens(halfedge)) {
        if (k < ring.size()) open.push_back(halfedge);
      } else if (!open.empty()) {
        pair(open.back(), halfedge);
        open.pop_back();
        paired += 2;
      }
    }
    result_.unpaired_halfedges += ring.size() - paired;
  }

  static TriangleId triangle_of(Halfedge halfedge) {
    return TriangleId(triangle_of_halfedge(halfedge));
  }

  Key key(TriangleId t) const { return sorted_corners(corners_of(result_.mesh, t)); }

  // The fans at every vertex; the one with the first triangle keeps the vertex.
  void copy_vertices() {
    result_.mesh = mesh_;
    for (const VertexId v : mesh_.points.ids()) result_.source.push_back(v);
    IdVector<TriangleId, std::uint32_t> fan_of(mesh_.triangles.size(), 0);
    for (const VertexId v : mesh_.points.ids()) {
      std::vector<std::vector<TriangleId>> fans = fans_at(v, fan_of);
      if (fans.size() < 2) continue;
      ++result_.split_vertices;
      std::vector<std::pair<Key, std::size_t>> order;
      for (std::size_t f = 0; f < fans.size(); ++f) {
        Key first = key(fans[f].front());
        for (const TriangleId t : fans[f]) first = std::min(first, key(t));
        order.emplace_back(first, f);
      }
      std::sort(order.begin(), order.end());
      for (std::size_t k = 1; k < order.size(); ++k) {
        const VertexId copy = result_.mesh.points.push_back(mesh_.points[v]);
        result_.source.push_back(v);
        ++result_.copies;
        for (const TriangleId t : fans[order[k].second]) {
          Triangle& triangle = result_.mesh.triangles[t];
          *std::find(triangle.begin(), triangle.end(), v) = copy;
        }
      }
    }
  }

  // `seen`: per triangle, 1 + the last vertex that a fan was collected for.
  std::vector<std::vector<TriangleId>> fans_at(VertexId v,
                                               IdVector<TriangleId, std::uint32_t>& seen) const {
    std::vector<std::vector<TriangleId>> fans;
    for (const TriangleId first : triangles_at_[v]) {
      if (seen[first] == v.value + 1) continue;
      std::vector<TriangleId> fan{first};
      seen[first] = v.value + 1;
      for (std::size_t next = 0; next < fan.size(); ++next) {
        for (std::size_t i = 0; i < 3; ++i) {
          const Halfedge other = partner_[halfedge_of(fan[next], i)];
          const bool at_v = mesh_.triangles[fan[next]][i] != v;
          if (!at_v || other == no_halfedge || seen[triangle_of(other)] == v.value + 1) continue;
          seen[triangle_of(other)] = v.value + 1;
          fan.push_back(triangle_of(other));
        }
      }
      fans.push_back(std::move(fan));
    }
    return fans;
  }

  // Pairs of halfedges (each by one of them) that share both ends with another pair, but for the
  // first.
  std::vector<Halfedge> find_seams() {
    std::vector<std::tuple<VertexId, VertexId, Key, Key, Halfedge>> pairs;
    for (const Halfedge suspect : suspects_) {
      const Halfedge other = partner_[suspect];
      const Halfedge halfedge = other == no_halfedge ? suspect : std::min(suspect, other);
      const auto [from, to] = ends_of_halfedge(result_.mesh, halfedge);
      Key first = key(triangle_of(suspect));
      Key second = other == no_halfedge ? first : key(triangle_of(other));
      if (second < first) std::swap(first, second);  // triangles of two pairs may coincide
      pairs.emplace_back(std::min(from, to), std::max(from, to), first, second, halfedge);
    }
    suspects_.clear();
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<Halfedge> seams;
    for (std::size_t k = 1; k < pairs.size(); ++k) {
      const auto& [a, b, first, second, halfedge] = pairs[k];
      if (a == std::get<0>(pairs[k - 1]) && b == std::get<1>(pairs[k - 1]))
        seams.push_back(halfedge);
    }
    return seams;
  }

  // Halfedges move when their triangle is cut, and take their flag along to where the scan comes
  // later.
  void split_seams(const std::vector<Halfedge>& seams) {
    is_seam_.assign(partner_.size(), 0);
    for (const Halfedge halfedge : seams) is_seam_[halfedge] = 1;
    for (Halfedge halfedge = 0; halfedge < partner_.size(); ++halfedge) {
      if (is_seam_[halfedge] == 0) continue;
      is_seam_[halfedge] = 0;
      const Halfedge other = partner_[halfedge];
      const auto [a, b] = ends_of_halfedge(result_.mesh, halfedge);
      const Point middle = midpoint(result_.mesh.points[a], result_.mesh.points[b]);
      const VertexId m = result_.mesh.points.push_back(middle);
      const VertexId smaller_end = result_.mesh.points[b] < result_.mesh.points[a] ? b : a;
      result_.source.push_back(VertexId(result_.source[smaller_end]));
      ++result_.midpoints;
      const Halfedge rest = cut(halfedge, m);
      if (other == no_halfedge) continue;
      const bool same_direction = ends_of_halfedge(result_.mesh, other)[0] == a;
      const Halfedge rest_of_other = cut(other, m);
      pair(halfedge, same_direction ? other : rest_of_other);
      pair(rest, same_direction ? rest_of_other : other);
    }
  }

  static Point midpoint(const Point& a, const Point& b) {
    const Point& low = std::min(a, b);  // the same bits for both directions
    const Point& high = std::max(a, b);
    return 0.5 * low + 0.5 * high;
  }

  // Cuts the triangle (c, a, b) of halfedge a -> b into (c, a, m), which keeps its id and the
  // halfedge a -> m in place, and (c, m, b); returns the halfedge m -> b. The partners of a -> m
  // and m -> b are open.
  Halfedge cut(Halfedge halfedge, VertexId m) {
    const TriangleId t = triangle_of(halfedge);
    const std::size_t i = corner_of_halfedge(halfedge);
    Triangle& triangle = result_.mesh.triangles[t];
    const Triangle other_part{triangle[i], m, triangle[(i + 2) % 3]};
    triangle[(i + 2) % 3] = m;
    const TriangleId t2 = result_.mesh.triangles.push_back(other_part);
    partner_.resize(partner_.size() + 3, no_halfedge);
    is_seam_.resize(is_seam_.size() + 3, 0);
    const Halfedge cut_here = halfedge_of(t, (i + 1) % 3);
    const Halfedge moved = halfedge_of(t2, 1);
    if (const Halfedge outer = partner_[cut_here]; outer != no_halfedge) pair(outer, moved);
    is_seam_[moved] = std::exchange(is_seam_[cut_here], std::uint8_t{0});
    pair(cut_here, halfedge_of(t2, 2));
    partner_[halfedge] = no_halfedge;
    for (const Halfedge s : {cut_here, moved, halfedge_of(t2, 2)}) suspects_.push_back(s);
    return halfedge_of(t2, 0);
  }

  const TriangleMesh& mesh_;
  HalfedgeRings rings_;
  TrianglesAtVertices triangles_at_;
  std::vector<Halfedge> partner_;   // grows with result_.mesh.triangles
  std::vector<Halfedge> suspects_;  // halfedges whose pair may share both ends with another
  std::vector<std::uint8_t> is_seam_;
  SplitSurface result_;
};

}  // namespace

SplitSurface split_nonmanifold(const TriangleMesh& mesh) { return Splitter(mesh).run(); }

}  // namespace cocoon
