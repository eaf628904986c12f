// The cocone by its definition: points along a dual edge are tested one by one.
#pragma once

#include "cocone/cocones.h"
#include "delaunay/voronoi_dual.h"
#include "geom/point.h"

namespace cocoon::ref {

struct SampledCocone {
  bool meets = false;  // some sample of the edge lies in the cocone
  double radius = 0;   // largest distance of such a sample from p, crossings refined by bisection
  bool borderline = false;  // samples come so close to the cone that sampling cannot decide
};

// Samples of the edge y(t) = from + t (to - from) or from + t direction, `samples` of them, with
// the cocone { y : |(y - p) . n| <= cosine |y - p| }. Rays are sampled up to 1e6 times their
// distance; their radius is infinite if they end in the cocone. Complexity: O(samples).
SampledCocone sample_cocone(const DualEdge& edge, const Point& p, const Vec3& n, double cosine,
                            int samples);

}  // namespace cocoon::ref
