#include "cocone/steps/triangulate_points.h"

#include <vector>

#include "delaunay/require_points.h"
#include "geom/errors.h"
#include "geom/working_scale.h"

namespace cocoon {

namespace {

void require_exact(Points points, double scale) {
  require_finite(points);
  if (scales_exactly(points, scale)) return;
  throw InputError(
      "the coordinates reach beyond 2^100 (1.27e30), and some of them are so much smaller that "
      "no double can hold both after scaling; set those to 0, or use other units");
}

}  // namespace

DelaunayResult triangulate_points(Points points, const DelaunayOptions& options,
                                  const Execution& execution) {
  require_comparable_sizes(points, execution);
  const double scale = working_scale(points);
  if (scale == 1) return delaunay(points, options, execution);
  require_exact(points, scale);
  return delaunay(scaled(points, scale), options, execution);
}

}  // namespace cocoon
