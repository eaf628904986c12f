#include "delaunay/require_points.h"

#include <algorithm>
#include <string>

#include "delaunay/triangulation.h"
#include "geom/errors.h"
#include "geom/messages/counted.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {

void require_ids(std::size_t points) {
  if (points < infinite_vertex.value) return;
  throw InputError("too many points: at most " + std::to_string(infinite_vertex.value - 1) +
                   " can be numbered");
}

void require_finite(Points points, const Execution& execution) {
  const auto are_finite = [&](std::size_t begin, std::size_t end) {
    const Points chunk = points.subspan(begin, end - begin);
    return std::all_of(chunk.begin(), chunk.end(), [](const Point& p) { return is_finite(p); });
  };
  const int all_finite =
      parallel_reduce(execution, points.size(), 1, are_finite, [](int a, int b) { return a & b; });
  if (all_finite == 1) return;
  std::size_t bad = 0;
  std::size_t first = 0;
  for (std::size_t i = points.size(); i-- > 0;) {
    if (is_finite(points[i])) continue;
    ++bad;
    first = i;
  }
  throw InputError("point " + std::to_string(first) +
                   " (counted from 0) has a coordinate that is " + "not finite (" +
                   std::to_string(bad) + " such points): remove or repair them");
}

void require_space(int dimension, std::size_t count) {
  if (count < 4) {
    throw DegenerateInput("only " + counted(count, "different point") +
                          ": a triangulation of space needs at least 4; give more points");
  }
  if (dimension < 2) {
    throw DegenerateInput(
        "all points lie on one line: no triangulation of space; a surface needs points off the "
        "line, and off any plane");
  }
  if (dimension < 3) {
    throw DegenerateInput(
        "all points lie in one plane: no triangulation of space; a surface needs points off the "
        "plane");
  }
}

}  // namespace cocoon
