// The point of a segment that is closest to a given one.
#pragma once

#include "geom/point.h"

namespace cocoon {

// Of the segment from a to b; a if it has no length. Off by a few roundings of the coordinates.
// Precondition: squares of its length neither overflow nor vanish. Complexity: O(1).
inline Point closest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Vec3 along = b - a;
  const double length = squared_norm(along);
  if (!(length > 0)) return a;
  const double t = dot(p - a, along) / length;
  return t <= 0 ? a : t >= 1 ? b : a + t * along;
}

}  // namespace cocoon
