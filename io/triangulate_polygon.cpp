#include "io/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geom/orient3d.h"
#include "geom/sign.h"

namespace cocoon {

namespace {

struct Planar {
  double x = 0;
  double y = 0;

  friend bool operator==(const Planar&, const Planar&) = default;
};

// Exact.
Sign turn(const Planar& a, const Planar& b, const Planar& c) {
  return orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
}

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

// Cuts triangles off until three corners are left.
class EarClipper {
 public:
  EarClipper(Points points, std::span<const VertexId> corners, std::vector<Triangle>& triangles)
      : corners_(corners), polygon_(project(points, corners)), triangles_(triangles) {
    for (std::size_t i = 0; i < corners.size(); ++i) rest_.push_back(i);
  }

  void run() {
    cut_repeats();
    if (!is_convex()) {
      const auto ear = [&](std::size_t i) { return is_ear(i); };
      const auto flat = [&](std::size_t i) { return turn_at(i) == Sign::zero; };
      while (rest_.size() > 3 && (cut_first(ear) || cut_first(flat))) continue;
    }
    cut_fan();
  }

 private:
  std::size_t rest_at(std::size_t i) const { return rest_[i % rest_.size()]; }
  const Planar& at(std::size_t i) const { return polygon_[rest_at(i)]; }
  const Planar& before(std::size_t i) const { return at(i + rest_.size() - 1); }
  Sign turn_at(std::size_t i) const { return turn(before(i), at(i), at(i + 1)); }

  // Only left turns, and no corner at which the polygon runs back the way it came.
  bool is_convex() const {
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const Sign sign = turn_at(i);
      if (sign == Sign::negative) return false;
      if (sign == Sign::zero && runs_back(before(i), at(i), at(i + 1))) return false;
    }
    return true;
  }

  // Of three points of a line, the middle one not equal to another.
  static bool runs_back(const Planar& a, const Planar& b, const Planar& c) {
    return a.x != b.x ? (a.x < b.x) != (b.x < c.x) : (a.y < b.y) != (b.y < c.y);
  }

  // Whether the triangle at corner i turns left, and the polygon passes through neither its inside
  // nor the inside of the cut. A corner on one of the two sides that are there may only touch it
  // from outside: such is one of the two ends of a bridge to a hole, at the same place.
  bool is_ear(std::size_t i) const {
    const Planar& a = before(i);
    const Planar& b = at(i);
    const Planar& c = at(i + 1);
    if (turn(a, b, c) != Sign::positive) return false;
    const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
    const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
    bool touched = false;
    for (std::size_t k = i + 2; k + 1 < i + rest_.size(); ++k) {
      const Planar& p = at(k);
      if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) continue;
      const Sign ab = turn(a, b, p);
      if (ab == Sign::negative) continue;
      const Sign bc = turn(b, c, p);
      if (bc == Sign::negative) continue;
      const Sign ca = turn(c, a, p);
      if (ca == Sign::negative) continue;
      if (ab == Sign::positive && bc == Sign::positive) return false;
      // From a point on some of the three lines, the inside is to the left of these.
      for (const Planar& q : {before(k), at(k + 1)}) {
        if ((ab == Sign::positive || turn(a, b, q) == Sign::positive) &&
            (bc == Sign::positive || turn(b, c, q) == Sign::positive) &&
            (ca == Sign::positive || turn(c, a, q) == Sign::positive)) {
          return false;
        }
      }
      touched = true;
    }
    return !touched || is_inside(a, b, c);
  }

  // Whether the polygon goes around the triangle. Where nothing else is left between two corners at
  // the same place, the polygon runs back along the triangle's sides and has nothing inside.
  bool is_inside(const Planar& a, const Planar& b, const Planar& c) const {
    const Planar p = {a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3};
    const bool found = turn(a, b, p) == Sign::positive && turn(b, c, p) == Sign::positive &&
                       turn(c, a, p) == Sign::positive;
    if (!found) return true;  // too thin for the digits of its middle
    int turns = 0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const Planar& from = at(i);
      const Planar& to = at(i + 1);
      if (from.y <= p.y && to.y > p.y && turn(from, to, p) == Sign::positive) ++turns;
      if (from.y > p.y && to.y <= p.y && turn(from, to, p) == Sign::negative) --turns;
    }
    return turns > 0;
  }

  void cut(std::size_t i) {
    triangles_.push_back(
        {corners_[rest_at(i + rest_.size() - 1)], corners_[rest_at(i)], corners_[rest_at(i + 1)]});
    rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  // Cuts the first corner off that may be cut; false if there is none.
  template <class MayBeCut>
  bool cut_first(const MayBeCut& may_be_cut) {
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (!may_be_cut(i)) continue;
      cut(i);
      return true;
    }
    return false;
  }

  // Corners at the place of the next one.
  void cut_repeats() {
    for (std::size_t i = rest_.size(); i > 0 && rest_.size() > 3; --i) {
      if (at(i - 1) == at(i)) cut(i - 1);
    }
  }

  void cut_fan() {
    for (std::size_t i = 1; i + 1 < rest_.size(); ++i) {
      triangles_.push_back({corners_[rest_[0]], corners_[rest_[i]], corners_[rest_[i + 1]]});
    }
  }

  std::span<const VertexId> corners_;
  std::vector<Planar> polygon_;
  std::vector<Triangle>& triangles_;
  std::vector<std::size_t> rest_;  // positions in `corners_` that are not cut off yet
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
