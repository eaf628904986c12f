#include "update/disproved_facets.h"

#include <algorithm>
#include <cmath>

#include "geom/closest_facet.h"
#include "geom/nearest_point.h"
#include "geom/require_size.h"
#include "geom/sort_ids.h"
#include "geom/thin_points.h"
#include "update/model/near_facets.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// A sample off the model, and the way along its normal on which none of the old surface is left.
struct Witness {
  Point place;
  Vec3 outward;
};

std::vector<Point> places_of(const std::vector<Witness>& witnesses) {
  std::vector<Point> places;
  places.reserve(witnesses.size());
  for (const Witness& w : witnesses) places.push_back(w.place);
  return places;
}

void keep_off_model(const ModelIndex& model, double distance, std::vector<Witness>& witnesses) {
  const std::vector<double> heights = squared_heights(model, places_of(witnesses), distance);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (heights[k] > distance * distance) witnesses[kept++] = witnesses[k];
  }
  witnesses.resize(kept);
}

class Gaze {
 public:
  Gaze(const ModelIndex& model, const Scan& scan, const std::vector<Witness>& witnesses,
       const DisprovedOptions& options)
      : model_(model),
        scan_(scan),
        options_(options),
        near_(model, places_of(witnesses), options.reach * scan.spacing),
        tree_(scan.samples) {}

  // `none` if it disproves nothing.
  TriangleId disproved_by(const Witness& w) const {
    const TriangleId facet = first_facet(w);
    if (facet.is_none()) return facet;
    const Point center = model_.centroid(facet);
    const bool is_scanned = tree_.any_near(center, options_.scanned * scan_.spacing);
    return is_scanned || is_sheltered(w, center) ? TriangleId() : facet;
  }

 private:
  TriangleId first_facet(const Witness& w) const {
    const double bound = near_.reach() * near_.reach();
    const ClosestFacet closest = near_.closest(w.place, bound, [](TriangleId) { return true; });
    if (closest.triangle.is_none()) return {};
    const double side = dot(model_.normal(closest.triangle), closest.point - w.place);
    if (std::abs(side) < options_.min_side_cosine * std::sqrt(closest.squared_distance)) return {};
    const bool is_inside = side > 0;
    const Vec3 gaze = is_inside ? w.outward : -1.0 * w.outward;
    const auto is_seen = [&](TriangleId t) {
      const Vec3 way = model_.centroid(t) - w.place;
      return (dot(model_.normal(t), way) > 0) == is_inside &&
             dot(way, gaze) >= options_.min_cosine * norm(way);
    };
    return near_.closest(w.place, bound, is_seen).triangle;
  }

  // Whether a sample that is not of the same surface lies near the way.
  bool is_sheltered(const Witness& w, const Point& facet) const {
    const double shelter = options_.shelter * scan_.spacing;
    const auto is_other_surface = [&](PointId p) {
      return std::abs(dot(scan_.samples[p.index()] - w.place, w.outward)) > shelter;
    };
    const Vec3 way = facet - w.place;
    const double length = norm(way);
    const Vec3 step = (0.5 * scan_.spacing / length) * way;
    Point place = w.place + 2.0 * step;
    for (double at = scan_.spacing; at < length; at += 0.5 * scan_.spacing) {
      if (tree_.any_near(place, shelter, is_other_surface)) return true;
      place = place + step;
    }
    return false;
  }

  const ModelIndex& model_;
  const Scan& scan_;
  const DisprovedOptions& options_;
  NearFacets near_;
  NearestPointTree tree_;
};

// By these witnesses alone.
std::vector<TriangleId> disproved_by(std::vector<Witness> witnesses, const ModelIndex& model,
                                     const Scan& scan, const DisprovedOptions& options) {
  keep_off_model(model, options.off_model * scan.spacing, witnesses);
  if (witnesses.empty()) return {};
  const Gaze gaze(model, scan, witnesses, options);
  std::vector<TriangleId> found;
  for (const Witness& w : witnesses) {
    const TriangleId facet = gaze.disproved_by(w);
    if (!facet.is_none()) found.push_back(facet);
  }
  make_set(found);
  return found;
}

// All that have a normal, or if `distance` is above zero, few that are so far apart.
std::vector<Witness> witnesses_of(const Scan& scan, std::span<const Vec3> outward,
                                  double distance) {
  std::vector<Witness> all;
  std::vector<Point> places;
  for (std::size_t k = 0; k < outward.size(); ++k) {
    if (outward[k] == Vec3{}) continue;
    all.push_back({scan.samples[k], outward[k]});
    places.push_back(scan.samples[k]);
  }
  if (distance == 0 || all.empty()) return all;
  std::vector<Witness> few;
  for (const PointId p : thin_points(places, distance)) few.push_back(all[p.index()]);
  return few;
}

}  // namespace

std::vector<TriangleId> disproved_facets(const ModelIndex& model, const Scan& scan,
                                         std::span<const Vec3> outward, const TriangleSet& settled,
                                         const DisprovedOptions& options) {
  require_options("disproved_facets", options);
  require_size("disproved_facets", "normals of the samples", outward.size(), scan.samples.size());
  require_size("disproved_facets", "flags of facets", settled.size(),
               model.mesh().triangles.size());
  const auto disproved = [&](double apart) {
    return disproved_by(witnesses_of(scan, outward, apart * scan.spacing), model, scan, options);
  };
  if (options.apart > 0) {
    const std::vector<TriangleId> by_few = disproved(options.apart);
    const auto is_settled = [&](TriangleId t) { return settled[t] != 0; };
    if (std::all_of(by_few.begin(), by_few.end(), is_settled)) return {};
  }
  return disproved(0);
}

}  // namespace cocoon
