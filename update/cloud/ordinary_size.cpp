#include "update/cloud/ordinary_size.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "delaunay/require_points.h"
#include "geom/errors.h"
#include "geom/point.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// What is not finite is another check's to name.
bool has_ordinary_size(Points points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max(largest, max_norm(p));
  return largest == 0 || !std::isfinite(largest) || (largest >= 0x1p-200 && largest <= 0x1p+200);
}

void require_triangulable_cloud(Points cloud, const std::string& name) {
  try {
    require_finite(cloud);
    require_comparable_sizes(cloud);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

}  // namespace

void require_ordinary_size(Points model, std::span<const std::vector<Point>> clouds) {
  std::string too_far;
  if (!has_ordinary_size(model)) too_far = "the model";
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    const std::string name =
        "cloud " + std::to_string(c + 1) + " of " + std::to_string(clouds.size());
    require_triangulable_cloud(clouds[c], name);
    if (too_far.empty() && !has_ordinary_size(clouds[c])) too_far = name;
  }
  if (too_far.empty()) return;
  throw InputError(too_far +
                   ": its largest coordinate is not between 2^-200 (6.2e-61) and 2^200 (1.6e60), "
                   "where an update can measure lengths; use other units for model and clouds");
}

}  // namespace cocoon
