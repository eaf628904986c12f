#include "update/scan_ends.h"

#include <algorithm>
#include <cstdint>

#include "geom/arrays/sort_ids.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/box.h"
#include "geom/search/nearest_point.h"
#include "update/cloud/scanned_places.h"
#include "update/model/reached_cells.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

std::vector<Point> centroids(const ModelIndex& model, const std::vector<TriangleId>& facets) {
  std::vector<Point> points;
  points.reserve(facets.size());
  for (const TriangleId t : facets) points.push_back(model.centroid(t));
  return points;
}

// Whether facets were scanned.
class Coverage {
 public:
  // `places`: all that will be asked about, and their neighbors.
  Coverage(const ModelIndex& model, std::span<const Scan> scans, Points places, double reach)
      : model_(model), known_(model.mesh().triangles.size()) {
    for (const Scan& scan : scans) {
      const double distance = reach * scan.spacing;
      scanned_.add(points_near(scan.samples, places, distance), distance);
    }
  }

  bool is_scanned(TriangleId t) {
    if (known_[t] == 0) known_[t] = scanned_.contain(model_.centroid(t)) ? 1 : 2;
    return known_[t] == 1;
  }

 private:
  const ModelIndex& model_;
  ZeroedArray<TriangleId, std::uint8_t> known_;  // 1: scanned, 2: not scanned
  ScannedPlaces scanned_;
};

// Takes out the places with a sample of the scan near them that is not on the model.
void leave_out_changes(const ModelIndex& model, const Scan& scan, const ScanEndOptions& options,
                       std::vector<TriangleId>& ends) {
  if (ends.empty()) return;
  const double around = options.change_reach * scan.spacing;
  const double off_model = options.off_model * scan.spacing;
  const std::vector<Point> asked = points_near(scan.samples, centroids(model, ends), around);
  if (asked.empty()) return;
  const std::vector<Point> off = samples_off_model(model, asked, off_model, scan.shift);
  if (off.empty()) return;
  const NearestPointTree changed(off);
  std::erase_if(ends, [&](TriangleId t) { return changed.any_near(model.centroid(t), around); });
}

}  // namespace

bool reaches_beyond(const ModelIndex& model, std::span<const TriangleId> among,
                    std::span<const Scan> scans, const ScanEndOptions& options) {
  require_options("reaches_beyond", options);
  return reaches_beyond(model, among, scans, options.scanned);
}

bool reaches_beyond(const ModelIndex& model, std::span<const TriangleId> among,
                    std::span<const Scan> scans, double reach) {
  if (scans.empty()) return false;
  Box box;
  for (const Scan& scan : scans) {
    Box around = box_of(scan.samples);
    around.enlarge(reach * scan.spacing);
    box.include(around);
  }
  return std::any_of(among.begin(), among.end(),
                     [&](TriangleId t) { return !contains(box, model.centroid(t)); });
}

std::vector<TriangleId> scan_ends(const ModelIndex& model, std::span<const TriangleId> among,
                                  std::span<const Scan> scans, const ScanEndOptions& options) {
  require_options("scan_ends", options);
  if (scans.empty() || among.empty()) return {};
  std::vector<TriangleId> around(among.begin(), among.end());
  for (const TriangleId t : among) {
    for (const TriangleId next : model.neighbors()[t]) {
      if (!next.is_none()) around.push_back(next);
    }
  }
  make_set(around);
  Coverage coverage(model, scans, centroids(model, around), options.scanned);
  std::vector<TriangleId> ends;
  for (const TriangleId t : among) {
    if (coverage.is_scanned(t)) continue;
    const auto& neighbors = model.neighbors()[t];
    const bool at_scan = std::any_of(neighbors.begin(), neighbors.end(), [&](TriangleId next) {
      return !next.is_none() && coverage.is_scanned(next);
    });
    if (at_scan) ends.push_back(t);
  }
  for (const Scan& scan : scans) leave_out_changes(model, scan, options, ends);
  return ends;
}

bool scan_ends_under(const ModelIndex& model, const Regions& regions, const CloudChoice& choice,
                     const Scan& scan, const ScanEndOptions& options) {
  IdVector<RegionId, std::uint8_t> goes(regions.regions.size(), 0);
  for (const RegionVerdict& verdict : choice.regions) goes[verdict.region] = verdict.under_cloud;
  std::vector<TriangleId> among;
  regions.region_of_facet.visit_where([&](RegionId r) { return !r.is_none() && goes[r] != 0; },
                                      [&](TriangleId t) { among.push_back(t); });
  const std::span scans(&scan, 1);
  return reaches_beyond(model, among, scans, options) &&
         !scan_ends(model, among, scans, options).empty();
}

}  // namespace cocoon
