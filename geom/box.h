// Axis-parallel boxes.
#pragma once

#include <algorithm>
#include <limits>

#include "geom/point.h"

namespace cocoon {

// The closed box from `low` to `high`. The default one is empty: it contains no point, including a
// point in it makes it that point, and including it in another changes nothing.
struct Box {
  Point low = {infinity, infinity, infinity};
  Point high = {-infinity, -infinity, -infinity};

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  bool is_empty() const { return !(low.x <= high.x); }
  Vec3 size() const { return is_empty() ? Vec3{} : high - low; }
  Point center() const { return is_empty() ? Point{} : 0.5 * low + 0.5 * high; }

  void include(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void include(const Box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y),
           std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y),
            std::max(high.z, other.high.z)};
  }
  void enlarge(double by) {
    low = low - Vec3{by, by, by};
    high = high + Vec3{by, by, by};
  }

  friend bool operator==(const Box&, const Box&) = default;
};

inline Box box_of(Points points) {
  Box box;
  for (const Point& p : points) box.include(p);
  return box;
}

// Without a branch, for passes over many points of which few lie inside.
inline bool contains(const Box& box, const Point& p) {
  bool holds = p.x >= box.low.x;
  holds &= p.x <= box.high.x;
  holds &= p.y >= box.low.y;
  holds &= p.y <= box.high.y;
  holds &= p.z >= box.low.z;
  holds &= p.z <= box.high.z;
  return holds;
}

inline bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

// Whether the ray from p along `way` meets the box, within rounding: near an edge it may be told
// wrong. Preconditions: `way` is not zero, the box not empty.
inline bool ray_meets(const Point& p, const Vec3& way, const Box& box) {
  double from = 0;
  double to = Box::infinity;
  const auto clip = [&](double x, double step, double low, double high) {
    if (step == 0) {
      if (x < low || x > high) to = -1;
      return;
    }
    const double a = (low - x) / step;
    const double b = (high - x) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  clip(p.x, way.x, box.low.x, box.high.x);
  clip(p.y, way.y, box.low.y, box.high.y);
  clip(p.z, way.z, box.low.z, box.high.z);
  return from <= to;
}

// Squared distance of p to the box, 0 inside. Never more than squared_distance(p, q) for a q in
// the box, rounding included: each step rounds monotonically.
inline double squared_distance(const Point& p, const Box& box) {
  const auto gap = [](double x, double low, double high) {
    return x < low ? x - low : x > high ? x - high : 0.0;
  };
  return squared_norm(Vec3{gap(p.x, box.low.x, box.high.x), gap(p.y, box.low.y, box.high.y),
                           gap(p.z, box.low.z, box.high.z)});
}

}  // namespace cocoon
