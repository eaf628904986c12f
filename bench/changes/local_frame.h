// A place in space with three directions at right angles, in which parts and changes are designed.
#pragma once

#include "geom/point.h"
#include "geom/random/random.h"

namespace cocoon::bench {

struct LocalFrame {
  Point origin = {};
  Vec3 x = {1, 0, 0};
  Vec3 y = {0, 1, 0};
  Vec3 z = {0, 0, 1};

  // The coordinates of a place in this frame, and back.
  Point local(const Point& p) const {
    const Vec3 from = p - origin;
    return Point{} + Vec3{dot(from, x), dot(from, y), dot(from, z)};
  }
  Point world(const Point& q) const { return origin + q.x * x + q.y * y + q.z * z; }
};

// With z along the unit vector `up`, turned about it at random.
inline LocalFrame random_frame(const Point& origin, const Vec3& up, Random& random) {
  Vec3 across = cross(up, random.on_unit_sphere());
  while (squared_norm(across) < 1e-4) across = cross(up, random.on_unit_sphere());
  const Vec3 x = unit(across);
  return {origin, x, cross(up, x), up};
}

}  // namespace cocoon::bench
