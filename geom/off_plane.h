// Flat clouds, which have no triangulation of space, made just not flat.
#pragma once

#include <vector>

#include "geom/point.h"

namespace cocoon {

struct OffPlaneOptions {
  // How far points are moved at most, relative to the extent of the cloud: far less than they are
  // apart, far more than rounding. Very far from the origin, where it is not: 2^-44 of the largest
  // coordinate.
  double share = 0x1p-20;
};

// If all points lie in one plane but not on one line, exactly: the same points, each moved along
// the plane's normal by a pseudo-random distance that its coordinates decide; equal points stay
// equal. Else empty, also if a coordinate is not finite.
// Complexity: O(1), as a rule, if they are not flat; else O(n). Deterministic: each point's place
// is a function of the set of points.
std::vector<Point> moved_off_plane(Points points, const OffPlaneOptions& options = {});

}  // namespace cocoon
