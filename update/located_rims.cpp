#include "update/located_rims.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geom/messages/require_size.h"
#include "update/cloud/wall_edges.h"
#include "update/pin_holes.h"
#include "update/rim_doubt.h"
#include "update/shadowed_rim.h"
#include "update/shared_edges.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

void report_loop(const RimLoop& loop, bool opened, CloudReport& report) {
  report.loops.push_back({.edges = loop.size(), .perimeter = loop.perimeter, .pin_hole = opened});
  report.boundary_points += loop.size();
}

// The clouds in an order that does not depend on theirs: by their smallest points, and where these
// are equal by all.
std::vector<std::size_t> turns_of(std::span<const std::vector<Point>> clouds) {
  std::vector<Point> smallest;
  for (const std::vector<Point>& cloud : clouds) {
    smallest.push_back(cloud.empty() ? Point() : *std::min_element(cloud.begin(), cloud.end()));
  }
  const auto sorted = [&](std::size_t c) {
    std::vector<Point> points = clouds[c];
    std::sort(points.begin(), points.end());
    return points;
  };
  std::vector<std::size_t> turns(clouds.size());
  std::iota(turns.begin(), turns.end(), std::size_t{0});
  std::sort(turns.begin(), turns.end(), [&](std::size_t a, std::size_t b) {
    if (smallest[a] != smallest[b]) return smallest[a] < smallest[b];
    return sorted(a) < sorted(b);
  });
  return turns;
}

class Locating {
 public:
  Locating(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
           std::span<const std::vector<CloudSurface>> others, const UpdateOptions& options,
           std::span<CloudReport> reports, const Execution& execution)
      : model_(model),
        clouds_(clouds),
        others_(others),
        options_(options),
        reports_(reports),
        execution_(execution),
        turns_(turns_of(clouds)),
        found_{std::vector<Overlap>(clouds.size()),
               std::vector<std::vector<std::size_t>>(clouds.size())} {}

  LocatedRims run() {
    for (const std::size_t c : turns_) locate(c);
    excuse_covered();
    for (const std::size_t c : turns_) {
      if (!is_on_model(c)) try_others(c, [&] { return is_on_model(c); });
    }
    for (const std::size_t c : turns_) prefer_clearer(c);
    take_shadowed_rims();
    return std::move(found_);
  }

 private:
  // What was known with another rim of one cloud.
  struct Before {
    CloudReport report;
    std::vector<Overlap> overlaps;  // of all: which clouds are covered depends on each rim
    std::vector<std::size_t> shared_with;
  };

  void locate(std::size_t c) {
    CloudRim& rim = reports_[c].surface.rim;
    for (RimLoop& loop : open_pin_holes(model_, clouds_[c], rim, options_.pin_holes)) {
      report_loop(loop, true, reports_[c]);
      rim.loops.push_back(std::move(loop));
    }
    if (clouds_.size() > 1) {
      const std::vector<Scan> scans = scans_of(clouds_, reports_);
      found_.shared_with[c] = mark_shared_edges(c, scans, rim, options_.shared);
    }
    mark_wall_edges(model_, clouds_, rim, options_.walls);
    found_.overlaps[c] = overlapping_facets(model_, rim, options_.overlap, execution_);
  }

  void excuse_covered() {
    excuse_covered_points(rims_of(reports_), clouds_, found_.overlaps, options_.overlap);
  }

  // Goes over to another surface. Returns what was there.
  Before exchange(std::size_t c, const CloudSurface& surface) {
    Before before{std::exchange(reports_[c], report_of_surface(surface)), found_.overlaps,
                  std::move(found_.shared_with[c])};
    locate(c);
    excuse_covered();
    return before;
  }

  void put_back(std::size_t c, Before before) {
    reports_[c] = std::move(before.report);
    found_.overlaps = std::move(before.overlaps);
    found_.shared_with[c] = std::move(before.shared_with);
  }

  bool is_on_model(std::size_t c) const { return found_.overlaps[c].status == OverlapStatus::ok; }

  // The first of the other surfaces, of the same kind, that is accepted.
  template <class Accepts>
  void try_others(std::size_t c, const Accepts& accepts) {
    const CloudStatus status = reports_[c].surface.status;
    for (const CloudSurface& other : others_[c]) {
      if (other.status != status || !other.has_loops()) continue;
      Before before = exchange(c, other);
      if (accepts()) return;
      put_back(c, std::move(before));
    }
  }

  bool take_shadowed(std::size_t c) {
    return take_shadowed_rim(reports_[c].surface.rim, options_.shadow, found_.overlaps[c]);
  }

  // Where nothing else helps; rims of the surfaces that are there come first. Clouds that a rim
  // covers lie on the model with it.
  void take_shadowed_rims() {
    const auto is_off_model = [](const Overlap& o) {
      return o.status == OverlapStatus::no_overlap;
    };
    if (std::none_of(found_.overlaps.begin(), found_.overlaps.end(), is_off_model)) return;
    for (const std::size_t c : turns_) {
      if (!is_on_model(c)) take_shadowed(c);
    }
    excuse_covered();
    for (const std::size_t c : turns_) {
      if (!is_on_model(c)) try_others(c, [&] { return is_on_model(c) || take_shadowed(c); });
    }
    excuse_covered();
  }

  RimDoubt doubt_of(std::size_t c) const {
    return rim_doubt(model_, clouds_[c], reports_[c].surface.rim, found_.overlaps[c],
                     options_.trace, options_.cut, execution_);
  }

  void prefer_clearer(std::size_t c) {
    if (others_[c].empty() || !is_on_model(c) || !found_.shared_with[c].empty()) return;
    const RimDoubt first = doubt_of(c);
    if (first.share <= options_.cut.clear_doubt) return;
    double least = options_.cut.clearer_rim * first.share;
    std::size_t compared = 1;
    std::size_t taken = 0;
    for (const CloudSurface& other : others_[c]) {
      if (other.status != CloudStatus::ok) continue;
      Before before = exchange(c, other);
      const RimDoubt theirs = is_on_model(c) ? doubt_of(c) : RimDoubt();
      const bool tells_enough = theirs.told >= options_.cut.min_told * first.told;
      const bool goes_too_far = theirs.reaches_far && !first.reaches_far;
      if (theirs.share < least && tells_enough && !goes_too_far) {
        least = theirs.share;
        taken = compared;
      } else {
        put_back(c, std::move(before));
      }
      ++compared;
    }
    reports_[c].compared_rims = compared;
    reports_[c].taken_rim = taken;
  }

  const ModelIndex& model_;
  std::span<const std::vector<Point>> clouds_;
  std::span<const std::vector<CloudSurface>> others_;
  const UpdateOptions& options_;
  std::span<CloudReport> reports_;
  const Execution& execution_;
  // What is found of one cloud depends on the rims that others have by then.
  std::vector<std::size_t> turns_;
  LocatedRims found_;
};

}  // namespace

CloudReport report_of_surface(CloudSurface surface) {
  CloudReport report;
  for (const RimLoop& loop : surface.rim.loops) report_loop(loop, false, report);
  report.surface = std::move(surface);
  return report;
}

LocatedRims locate_rims(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                        std::span<const std::vector<CloudSurface>> others,
                        const UpdateOptions& options, std::span<CloudReport> reports,
                        const Execution& execution) {
  require_size("locate_rims", "lists of other surfaces", others.size(), clouds.size());
  require_size("locate_rims", "reports", reports.size(), clouds.size());
  return Locating(model, clouds, others, options, reports, execution).run();
}

}  // namespace cocoon
