#include "update/scan_ends.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "geom/box.h"
#include "geom/nearest_point.h"
#include "update/near_facets.h"

namespace cocoon {

namespace {

// How near the scans come to facets, in spacings of each.
class Nearness {
 public:
  Nearness(const ModelIndex& model, std::span<const Scan> scans, double reach)
      : model_(model), scans_(scans), reach_(reach), known_(model.mesh().triangles.size(), 0) {
    for (const Scan& scan : scans) {
      trees_.emplace_back(scan.samples);
      boxes_.push_back(box_of(scan.samples));
      boxes_.back().enlarge(reach * scan.spacing);
    }
  }

  bool is_scanned(TriangleId t) {
    if (known_[t] == 0) known_[t] = is_near(model_.centroid(t)) ? 1 : 2;
    return known_[t] == 1;
  }

  // The largest spacing of those scans that are nearest to p.
  double spacing_at(const Point& p) const {
    double least = std::numeric_limits<double>::infinity();
    double spacing = 0;
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      const double distance = trees_[s].nearest(p).squared_distance;
      if (distance > least || (distance == least && scans_[s].spacing <= spacing)) continue;
      least = distance;
      spacing = scans_[s].spacing;
    }
    return spacing;
  }

 private:
  bool is_near(const Point& p) const {
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      const double reach = reach_ * scans_[s].spacing;
      if (!contains(boxes_[s], p)) continue;
      if (trees_[s].nearest(p).squared_distance <= reach * reach) return true;
    }
    return false;
  }

  const ModelIndex& model_;
  std::span<const Scan> scans_;
  double reach_;
  IdVector<TriangleId, std::uint8_t> known_;  // 1: scanned, 2: not scanned
  std::vector<NearestPointTree> trees_;
  std::vector<Box> boxes_;
};

// The samples near the places that lie farther from the model than off_model spacings.
std::vector<Point> samples_off_model(const ModelIndex& model, std::span<const Scan> scans,
                                     const std::vector<Point>& places,
                                     const ScanEndOptions& options) {
  const NearestPointTree near_place(places);
  Box extent = box_of(places);
  double largest = 0;
  for (const Scan& scan : scans) largest = std::max(largest, scan.spacing);
  extent.enlarge(options.change_reach * largest);
  std::vector<Point> off;
  for (const Scan& scan : scans) {
    const double around = options.change_reach * scan.spacing;
    std::vector<Point> asked;
    for (const Point& p : scan.samples) {
      if (!contains(extent, p)) continue;
      if (near_place.nearest(p).squared_distance <= around * around) asked.push_back(p);
    }
    if (asked.empty()) continue;
    const double reach = options.off_model * scan.spacing;
    const NearFacets near(model, asked, reach);
    for (const Point& p : asked) {
      const auto any = [](TriangleId) { return true; };
      if (near.closest(p, reach * reach, any).triangle.is_none()) off.push_back(p);
    }
  }
  return off;
}

}  // namespace

std::vector<TriangleId> scan_ends(const ModelIndex& model, const TriangleSet& among,
                                  std::span<const Scan> scans, const ScanEndOptions& options) {
  if (scans.empty()) return {};
  Nearness nearness(model, scans, options.scanned);
  std::vector<TriangleId> ends;
  std::vector<Point> places;
  for (const TriangleId t : among.ids()) {
    if (among[t] == 0 || nearness.is_scanned(t)) continue;
    const auto& neighbors = model.adjacency().neighbors[t];
    const bool at_scan = std::any_of(neighbors.begin(), neighbors.end(), [&](TriangleId next) {
      return !next.is_none() && nearness.is_scanned(next);
    });
    if (!at_scan) continue;
    ends.push_back(t);
    places.push_back(model.centroid(t));
  }
  if (ends.empty()) return {};
  const std::vector<Point> off = samples_off_model(model, scans, places, options);
  if (off.empty()) return ends;
  const NearestPointTree changed(off);
  std::erase_if(ends, [&](TriangleId t) {
    const Point p = model.centroid(t);
    const double reach = options.change_reach * nearness.spacing_at(p);
    return changed.nearest(p).squared_distance <= reach * reach;
  });
  return ends;
}

bool scan_ends_under(const ModelIndex& model, const Regions& regions, const CloudChoice& choice,
                     const Scan& scan, const ScanEndOptions& options) {
  IdVector<RegionId, std::uint8_t> goes(regions.regions.size(), 0);
  for (const RegionVerdict& verdict : choice.regions) goes[verdict.region] = verdict.under_cloud;
  Box box = box_of(scan.samples);
  box.enlarge(options.scanned * scan.spacing);
  TriangleSet among(regions.region_of_facet.size(), 0);
  bool reaches_beyond = false;
  for (const TriangleId t : among.ids()) {
    const RegionId r = regions.region_of_facet[t];
    if (r.is_none() || goes[r] == 0) continue;
    among[t] = 1;
    reaches_beyond = reaches_beyond || !contains(box, model.centroid(t));
  }
  return reaches_beyond && !scan_ends(model, among, std::span(&scan, 1), options).empty();
}

}  // namespace cocoon
