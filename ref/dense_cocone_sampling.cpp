#include "ref/dense_cocone_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cocoon::ref {
namespace {

// > 0 in the double cone, < 0 in the cocone, relative to the distance.
double depth_in_double_cone(const Vec3& x, const Vec3& n, double cosine) {
  return std::abs(dot(x, n)) / norm(x) - cosine;
}

// The last point in the cocone on the way from `in` (in it) to `out` (not in it), by bisection.
Vec3 last_in_cocone(Vec3 in, Vec3 out, const Vec3& n, double cosine) {
  for (int i = 0; i < 60; ++i) {
    const Vec3 middle = 0.5 * (in + out);
    (depth_in_double_cone(middle, n, cosine) <= 0 ? in : out) = middle;
  }
  return in;
}

}  // namespace

SampledCocone sample_cocone(const DualEdge& edge, const Point& p, const Vec3& n, double cosine,
                            int samples) {
  SampledCocone result;
  double shallowest = std::numeric_limits<double>::infinity();
  Vec3 previous;
  bool previous_inside = false;
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / (samples - 1);
    // Along a ray the steps grow: t / (1 - t) runs from 0 to a million.
    const double along = t / (1 - t + 1e-6) * (1 + distance(edge.from, p));
    const Vec3 x = edge.is_ray ? edge.from - p + along * edge.to
                               : (1 - t) * (edge.from - p) + t * (edge.to - p);
    const double depth = depth_in_double_cone(x, n, cosine);
    const bool inside = depth <= 0;
    shallowest = std::min(shallowest, depth);
    result.meets |= inside;
    if (inside) result.radius = std::max(result.radius, norm(x));
    if (i > 0 && inside != previous_inside) {
      const Vec3 last =
          inside ? last_in_cocone(x, previous, n, cosine) : last_in_cocone(previous, x, n, cosine);
      result.radius = std::max(result.radius, norm(last));
    }
    previous = x;
    previous_inside = inside;
  }
  result.borderline = std::abs(shallowest) < 2.0 / samples;
  if (edge.is_ray && depth_in_double_cone(edge.to, n, cosine) <= 0) {
    result.radius = std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace cocoon::ref
