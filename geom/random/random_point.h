// Random points of triangles.
#pragma once

#include "geom/point.h"
#include "geom/random/random.h"

namespace cocoon {

// Uniform in the triangle a, b, c. Takes two numbers of `random`. O(1).
inline Point random_point_in(const Point& a, const Point& b, const Point& c, Random& random) {
  double u = random.uniform();
  double v = random.uniform();
  if (u + v > 1) {  // the other half of the parallelogram
    u = 1 - u;
    v = 1 - v;
  }
  return a + u * (b - a) + v * (c - a);
}

}  // namespace cocoon
