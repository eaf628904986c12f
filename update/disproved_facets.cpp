#include "update/disproved_facets.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"
#include "geom/search/closest_facet.h"
#include "geom/search/nearest_point.h"
#include "geom/search/thin_points.h"
#include "update/cloud/off_samples.h"
#include "update/model/near_facets.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// What samples off the model see of it.
class Gaze {
 public:
  Gaze(const ModelIndex& model, const Scan& scan, const DisprovedOptions& options)
      : model_(model), scan_(scan), options_(options) {}

  // Of those that are off the model, with a normal each.
  std::vector<Disproof> disproofs_by(Points samples, std::span<const Outward> outward) {
    const std::vector<OffSample> off =
        outward_samples_off_model(model_, samples, outward, options_.off_model * scan_.spacing);
    if (off.empty()) return {};
    if (!tree_) tree_.emplace(scan_.samples);
    std::vector<Point> places;
    places.reserve(off.size());
    for (const OffSample& w : off) places.push_back(w.place);
    const NearFacets near(model_, places, options_.reach * scan_.spacing);
    std::vector<Disproof> found;
    for (const OffSample& w : off) {
      const Disproof seen = first_facet(near, w);
      if (!seen.facet.is_none() && is_disproved(w, seen.facet)) found.push_back(seen);
    }
    return found;
  }

 private:
  // Its facet is none if the sample sees none.
  Disproof first_facet(const NearFacets& near, const OffSample& w) const {
    const double bound = near.reach() * near.reach();
    const ClosestFacet closest = near.closest(w.place, bound);
    if (closest.triangle.is_none()) return {};
    const double side = dot(model_.normal(closest.triangle), closest.point - w.place);
    if (std::abs(side) < options_.min_side_cosine * std::sqrt(closest.squared_distance)) return {};
    const bool is_inside = side > 0;
    const bool is_presumed = w.outward.is_presumed();
    const Vec3 gaze = (is_inside ? 1.0 : -1.0) * (is_presumed ? w.outward.view : w.outward.normal);
    const double least = is_presumed ? options_.min_presumed_cosine : options_.min_cosine;
    const auto is_seen = [&](TriangleId t) {
      const Vec3 way = model_.centroid(t) - w.place;
      return (dot(model_.normal(t), way) > 0) == is_inside && dot(way, gaze) >= least * norm(way);
    };
    return {w.place, near.closest(w.place, bound, is_seen).triangle, is_inside};
  }

  bool is_disproved(const OffSample& w, TriangleId facet) const {
    const Point center = model_.centroid(facet);
    return !tree_->any_near(center, options_.scanned * scan_.spacing) && !is_sheltered(w, center);
  }

  // Whether a sample that is not of the same surface lies near the way.
  bool is_sheltered(const OffSample& w, const Point& facet) const {
    const double shelter = options_.shelter * scan_.spacing;
    const auto is_other_surface = [&](PointId p) {
      return std::abs(dot(scan_.samples[p.index()] - w.place, w.outward.normal)) > shelter;
    };
    const Vec3 way = facet - w.place;
    const double length = norm(way);
    const double stride = options_.step * scan_.spacing;
    const Vec3 step = (stride / length) * way;
    Point place = w.place + (scan_.spacing / stride) * step;
    for (double at = scan_.spacing; at < length; at += stride) {
      if (tree_->any_near(place, shelter, is_other_surface)) return true;
      place = place + step;
    }
    return false;
  }

  const ModelIndex& model_;
  const Scan& scan_;
  const DisprovedOptions& options_;
  std::optional<NearestPointTree> tree_;  // of all samples, made when it is asked
};

struct KnownSamples {
  std::vector<Point> places;
  std::vector<Outward> outward;
};

// Those whose normals are known.
KnownSamples known_samples(const Scan& scan, std::span<const Outward> outward) {
  KnownSamples known;
  for (std::size_t k = 0; k < outward.size(); ++k) {
    if (outward[k].normal == Vec3{}) continue;
    known.places.push_back(scan.samples[k]);
    known.outward.push_back(outward[k]);
  }
  return known;
}

std::vector<TriangleId> facets_of(std::span<const Disproof> disproofs) {
  std::vector<TriangleId> facets;
  facets.reserve(disproofs.size());
  for (const Disproof& d : disproofs) facets.push_back(d.facet);
  make_set(facets);
  return facets;
}

}  // namespace

std::vector<Disproof> disproofs(const ModelIndex& model, const Scan& scan,
                                std::span<const Outward> outward, const DisprovedOptions& options) {
  require_options("disproofs", options);
  require_size("disproofs", "normals of the samples", outward.size(), scan.samples.size());
  const KnownSamples known = known_samples(scan, outward);
  return Gaze(model, scan, options).disproofs_by(known.places, known.outward);
}

std::vector<TriangleId> disproved_facets(const ModelIndex& model, const Scan& scan,
                                         std::span<const Outward> outward,
                                         const TriangleSet& settled,
                                         const DisprovedOptions& options) {
  require_options("disproved_facets", options);
  require_size("disproved_facets", "normals of the samples", outward.size(), scan.samples.size());
  require_size("disproved_facets", "flags of facets", settled.size(),
               model.mesh().triangles.size());
  const KnownSamples known = known_samples(scan, outward);
  Gaze gaze(model, scan, options);
  if (options.apart > 0) {
    KnownSamples few;
    for (const PointId p : thin_points(known.places, options.apart * scan.spacing)) {
      few.places.push_back(known.places[p.index()]);
      few.outward.push_back(known.outward[p.index()]);
    }
    const std::vector<TriangleId> by_few = facets_of(gaze.disproofs_by(few.places, few.outward));
    const auto is_settled = [&](TriangleId t) { return settled[t] != 0; };
    if (std::all_of(by_few.begin(), by_few.end(), is_settled)) return {};
  }
  return facets_of(gaze.disproofs_by(known.places, known.outward));
}

}  // namespace cocoon
