#include "io/polygons/triangulate_polygon.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>

#include "geom/sign.h"
#include "io/polygons/corner_tree.h"

namespace cocoon {

namespace {

// The corners, projected along the coordinate axis closest to the area vector (Newell's sum), such
// that the polygon runs counterclockwise.
std::vector<Planar> project(Points points, std::span<const VertexId> corners) {
  const Point& origin = points[corners[0].index()];
  Vec3 area;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area =
        area + cross(points[corners[i].index()] - origin, points[corners[i + 1].index()] - origin);
  }
  const double ax = std::abs(area.x);
  const double ay = std::abs(area.y);
  const double az = std::abs(area.z);
  std::vector<Planar> planar;
  planar.reserve(corners.size());
  for (VertexId v : corners) {
    const Point& p = points[v.index()];
    if (az >= ax && az >= ay) {
      planar.push_back(area.z >= 0 ? Planar{p.x, p.y} : Planar{p.y, p.x});
    } else if (ax >= ay) {
      planar.push_back(area.x >= 0 ? Planar{p.y, p.z} : Planar{p.z, p.y});
    } else {
      planar.push_back(area.y >= 0 ? Planar{p.z, p.x} : Planar{p.x, p.z});
    }
  }
  return planar;
}

constexpr std::uint32_t nobody = 0xFFFFFFFFU;

// Cuts triangles off until three corners are left.
class EarClipper {
 public:
  EarClipper(Points points, std::span<const VertexId> corners, std::vector<Triangle>& triangles)
      : corners_(corners),
        polygon_(project(points, corners)),
        triangles_(triangles),
        left_(corners.size()),
        next_(corners.size()),
        previous_(corners.size()) {
    for (std::size_t i = 0; i < left_; ++i) {
      next_[i] = static_cast<std::uint32_t>(i + 1 < left_ ? i + 1 : 0);
      previous_[i] = static_cast<std::uint32_t>(i > 0 ? i - 1 : left_ - 1);
    }
  }

  void run() {
    cut_repeats();
    if (!is_convex()) cut_ears();
    cut_fan();
  }

 private:
  using Corner = std::uint32_t;
  // Smallest first.
  using Queue = std::priority_queue<Corner, std::vector<Corner>, std::greater<>>;

  // Why a triangle may not be cut off.
  enum class Obstacle { none, corner, passage };
  // Corners that wait until something changes at another one.
  struct Waiting {
    Corner corner;
    std::uint32_t look;  // at the corner, after which it waits
    std::uint32_t next;
  };

  const Planar& at(Corner i) const { return polygon_[i]; }
  bool is_cut(Corner i) const { return next_[i] == nobody; }
  Sign turn_at(Corner i) const { return turn(at(previous_[i]), at(i), at(next_[i])); }

  // Only left turns, and no corner at which the polygon runs back the way it came.
  bool is_convex() const {
    Corner i = first_;
    do {
      const Sign sign = turn_at(i);
      if (sign == Sign::negative) return false;
      if (sign == Sign::zero && runs_back(at(previous_[i]), at(i), at(next_[i]))) return false;
      i = next_[i];
    } while (i != first_);
    return true;
  }

  // Of three points of a line, the middle one not equal to another.
  static bool runs_back(const Planar& a, const Planar& b, const Planar& c) {
    return a.x != b.x ? (a.x < b.x) != (b.x < c.x) : (a.y < b.y) != (b.y < c.y);
  }

  // Always the first corner that may be cut. All that may be are in the queue: a corner that is
  // none waits until what hinders it changes.
  void cut_ears() {
    tree_.emplace(polygon_);
    first_waiting_ = {std::vector<std::uint32_t>(polygon_.size(), nobody),
                      std::vector<std::uint32_t>(polygon_.size(), nobody)};
    looks_.assign(polygon_.size(), 0);
    is_queued_.assign(polygon_.size(), 0);
    for (Corner i = 0; i < polygon_.size(); ++i) {
      if (is_cut(i)) {
        tree_->take_away(i);
      } else {
        queue(i);
      }
    }
    while (left_ > 3 && (cut_first_ear() || cut_first_flat())) continue;
  }

  bool cut_first_ear() {
    while (!queue_.empty()) {
      const Corner i = queue_.top();
      queue_.pop();
      is_queued_[i] = 0;
      if (is_cut(i) || !is_ear(i)) continue;
      cut_and_look_again(i);
      return true;
    }
    return false;
  }

  // Where the polygon runs straight on or back.
  bool cut_first_flat() {
    while (!flat_.empty()) {
      const Corner i = flat_.top();
      flat_.pop();
      if (is_cut(i) || turn_at(i) != Sign::zero) continue;
      cut_and_look_again(i);
      return true;
    }
    return false;
  }

  void cut_and_look_again(Corner i) {
    const Corner before = previous_[i];
    const Corner behind = next_[i];
    cut(i);
    tree_->take_away(i);
    for (const Corner neighbor : {before, behind}) {
      queue(neighbor);
      wake(Obstacle::passage, neighbor);
    }
    wake(Obstacle::corner, i);
    wake(Obstacle::passage, i);
    for (const Corner unclear : unclear_) queue(unclear);
    unclear_.clear();
  }

  void queue(Corner i) {
    if (is_cut(i) || is_queued_[i] != 0) return;
    is_queued_[i] = 1;
    queue_.push(i);
  }

  std::uint32_t& first_waiting(Obstacle obstacle, Corner at) {
    return first_waiting_[obstacle == Obstacle::corner ? 0 : 1][at];
  }

  void wait(Corner i, Obstacle obstacle, Corner at) {
    std::uint32_t& first = first_waiting(obstacle, at);
    waiting_.push_back({i, looks_[i], first});
    first = static_cast<std::uint32_t>(waiting_.size() - 1);
  }

  // Those that were looked at again since wait for something else.
  void wake(Obstacle obstacle, Corner at) {
    std::uint32_t k = std::exchange(first_waiting(obstacle, at), nobody);
    for (; k != nobody; k = waiting_[k].next) {
      if (waiting_[k].look == looks_[waiting_[k].corner]) queue(waiting_[k].corner);
    }
  }

  // Whether the triangle at corner i turns left, and the polygon passes through neither its inside
  // nor the inside of the cut.
  bool is_ear(Corner i) {
    ++looks_[i];
    const std::array<Planar, 3> triangle = {at(previous_[i]), at(i), at(next_[i])};
    const Sign sign = turn(triangle[0], triangle[1], triangle[2]);
    if (sign == Sign::zero) flat_.push(i);
    if (sign != Sign::positive) return false;
    bool touched = false;
    bool hindered = false;
    tree_->visit_near(triangle, [&](std::size_t k) {
      const auto corner = static_cast<Corner>(k);
      if (corner == i || corner == previous_[i] || corner == next_[i]) return true;
      const Obstacle obstacle = obstacle_at(corner, triangle, touched);
      hindered = obstacle != Obstacle::none;
      if (hindered) wait(i, obstacle, corner);
      return !hindered;
    });
    if (hindered) return false;
    if (!touched || is_inside(triangle[0], triangle[1], triangle[2])) return true;
    unclear_.push_back(i);
    return false;
  }

  // A corner on one of the two sides that are there may only touch the triangle from outside: such
  // is one of the two ends of a bridge to a hole, at the same place.
  Obstacle obstacle_at(Corner k, const std::array<Planar, 3>& triangle, bool& touched) const {
    const auto& [a, b, c] = triangle;
    const Planar& p = at(k);
    const Sign ab = turn(a, b, p);
    if (ab == Sign::negative) return Obstacle::none;
    const Sign bc = turn(b, c, p);
    if (bc == Sign::negative) return Obstacle::none;
    const Sign ca = turn(c, a, p);
    if (ca == Sign::negative) return Obstacle::none;
    if (ab == Sign::positive && bc == Sign::positive) return Obstacle::corner;
    // From a point on some of the three lines, the inside is to the left of these.
    for (const Planar& q : {at(previous_[k]), at(next_[k])}) {
      if ((ab == Sign::positive || turn(a, b, q) == Sign::positive) &&
          (bc == Sign::positive || turn(b, c, q) == Sign::positive) &&
          (ca == Sign::positive || turn(c, a, q) == Sign::positive)) {
        return Obstacle::passage;
      }
    }
    touched = true;
    return Obstacle::none;
  }

  // Whether the polygon goes around the triangle. Where nothing else is left between two corners at
  // the same place, the polygon runs back along the triangle's sides and has nothing inside.
  bool is_inside(const Planar& a, const Planar& b, const Planar& c) const {
    const Planar p = {a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3};
    const bool found = turn(a, b, p) == Sign::positive && turn(b, c, p) == Sign::positive &&
                       turn(c, a, p) == Sign::positive;
    if (!found) return true;  // too thin for the digits of its middle
    int turns = 0;
    Corner i = first_;
    do {
      const Planar& from = at(i);
      const Planar& to = at(next_[i]);
      if (from.y <= p.y && to.y > p.y && turn(from, to, p) == Sign::positive) ++turns;
      if (from.y > p.y && to.y <= p.y && turn(from, to, p) == Sign::negative) --turns;
      i = next_[i];
    } while (i != first_);
    return turns > 0;
  }

  void cut(Corner i) {
    const Corner before = previous_[i];
    const Corner behind = next_[i];
    triangles_.push_back({corners_[before], corners_[i], corners_[behind]});
    next_[before] = behind;
    previous_[behind] = before;
    next_[i] = previous_[i] = nobody;
    if (i == first_) first_ = behind;
    --left_;
  }

  // Corners at the place of the next one.
  void cut_repeats() {
    for (std::size_t i = polygon_.size(); i > 0 && left_ > 3; --i) {
      const auto corner = static_cast<Corner>(i - 1);
      if (at(corner) == at(next_[corner])) cut(corner);
    }
  }

  void cut_fan() {
    for (Corner i = next_[first_]; next_[i] != first_; i = next_[i]) {
      triangles_.push_back({corners_[first_], corners_[i], corners_[next_[i]]});
    }
  }

  std::span<const VertexId> corners_;
  std::vector<Planar> polygon_;
  std::vector<Triangle>& triangles_;
  // The corners that are not cut off yet, in a ring.
  std::size_t left_;
  Corner first_ = 0;
  std::vector<Corner> next_;
  std::vector<Corner> previous_;

  std::optional<CornerTree> tree_;
  Queue queue_;
  std::vector<char> is_queued_;
  Queue flat_;
  std::vector<std::uint32_t> looks_;
  std::vector<Waiting> waiting_;
  std::array<std::vector<std::uint32_t>, 2> first_waiting_;  // at each corner, of each obstacle
  std::vector<Corner> unclear_;  // whatever is cut may make ears of them
};

}  // namespace

void triangulate_polygon(Points points, std::span<const VertexId> corners,
                         std::vector<Triangle>& triangles) {
  triangles.clear();
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  EarClipper(points, corners, triangles).run();
}

}  // namespace cocoon
