#include "update/cloud/ordinary_size.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "geom/errors.h"

namespace cocoon {
namespace {

bool has_ordinary_size(Points points) {
  double largest = 0;
  for (const Point& p : points) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  // What is not finite is for delaunay() to name.
  return largest == 0 || !std::isfinite(largest) || (largest >= 0x1p-200 && largest <= 0x1p+200);
}

}  // namespace

void require_ordinary_size(Points model, std::span<const std::vector<Point>> clouds) {
  std::string too_far;
  if (!has_ordinary_size(model)) too_far = "the model";
  for (std::size_t c = 0; c < clouds.size() && too_far.empty(); ++c) {
    if (has_ordinary_size(clouds[c])) continue;
    too_far = "cloud " + std::to_string(c + 1) + " of " + std::to_string(clouds.size());
  }
  if (too_far.empty()) return;
  throw InputError(too_far +
                   ": its largest coordinate is not between 2^-200 (6.2e-61) and 2^200 (1.6e60), "
                   "where an update can measure lengths; use other units for model and clouds");
}

}  // namespace cocoon
