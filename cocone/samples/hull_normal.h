// The normal of a sample on the hull (poles.h).
#pragma once

#include <span>

#include "geom/point.h"

namespace cocoon {

// The direction of the sum of k unit normals; if that is shorter than 0.1 k, the principal
// eigenvector instead.
struct HullNormal {
  Vec3 normal;
  bool degenerate = false;
};
// `directions` is sorted on the way, so that the sum does not depend on its order.
HullNormal hull_normal(std::span<Vec3> directions);

}  // namespace cocoon
