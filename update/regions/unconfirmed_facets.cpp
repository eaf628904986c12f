#include "update/regions/unconfirmed_facets.h"

#include <cmath>
#include <vector>

#include "geom/search/nearest_point.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// A scan, and a search tree over its samples.
struct Searched {
  const Scan& scan;
  NearestPointTree samples;
};

enum class Told { nothing, confirmed, unconfirmed };

Told told_by(const Searched& searched, const Point& centroid, const Vec3& normal,
             const UnconfirmedOptions& options) {
  const Scan& scan = searched.scan;
  const Point at = centroid + scan.shift;
  const NearestPoint nearest = searched.samples.nearest(at);
  const double distance = std::sqrt(nearest.squared_distance);
  if (distance > options.near * scan.spacing) return Told::nothing;
  const double height = dot(scan.samples[nearest.point.index()] - at, normal);
  const bool is_on_it =
      distance <= options.reach * scan.spacing && std::abs(height) <= options.height * scan.spacing;
  return is_on_it ? Told::confirmed : Told::unconfirmed;
}

}  // namespace

TriangleSet unconfirmed_facets(const ModelIndex& model, std::span<const Scan> scans,
                               std::span<const TriangleId> asked,
                               const UnconfirmedOptions& options) {
  require_options("unconfirmed_facets", options);
  std::vector<Searched> searched;
  for (const Scan& scan : scans) {
    if (!scan.samples.empty()) searched.push_back({scan, NearestPointTree(scan.samples)});
  }
  TriangleSet unconfirmed(model.mesh().triangles.size(), 0);
  for (const TriangleId t : asked) {
    bool is_near = false;
    bool is_confirmed = false;
    for (const Searched& s : searched) {
      const Told told = told_by(s, model.centroid(t), model.normal(t), options);
      is_near = is_near || told != Told::nothing;
      is_confirmed = is_confirmed || told == Told::confirmed;
    }
    unconfirmed[t] = is_near && !is_confirmed ? 1 : 0;
  }
  return unconfirmed;
}

}  // namespace cocoon
