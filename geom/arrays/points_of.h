// Points by their ids.
#pragma once

#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// In the order of the ids, each of which is below the number of points. Complexity: O(ids).
inline std::vector<Point> points_of(Points points, std::span<const PointId> ids) {
  std::vector<Point> found;
  found.reserve(ids.size());
  for (const PointId p : ids) found.push_back(points[p.index()]);
  return found;
}

}  // namespace cocoon
