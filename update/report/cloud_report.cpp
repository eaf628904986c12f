#include "update/report/cloud_report.h"

#include <algorithm>
#include <utility>

#include "geom/angles.h"

namespace cocoon {

std::vector<CloudRim> rims_of(std::span<const CloudReport> clouds) {
  std::vector<CloudRim> rims;
  rims.reserve(clouds.size());
  for (const CloudReport& cloud : clouds) rims.push_back(cloud.surface.rim);
  return rims;
}

std::vector<std::uint8_t> partial_rims(std::span<const CloudReport> clouds) {
  std::vector<std::uint8_t> partial;
  for (const CloudReport& cloud : clouds) partial.push_back(cloud.surface.rim.is_partial() ? 1 : 0);
  return partial;
}

bool runs_around_handle(const CloudReport& cloud) {
  return !cloud.surface.rim.is_partial() &&
         std::any_of(cloud.loops.begin(), cloud.loops.end(), [](const LoopReport& loop) {
           return loop.match == LoopMatch::on_model &&
                  loop.separation == Separation::non_separating;
         });
}

std::vector<Scan> scans_of(std::span<const std::vector<Point>> clouds,
                           std::span<const CloudReport> reports) {
  std::vector<Scan> scans;
  scans.reserve(clouds.size());
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    scans.push_back({clouds[c], reports[c].surface.rim.median_edge, reports[c].believed_shift});
  }
  return scans;
}

std::vector<CloudRim> border_rims_of(std::span<const CloudReport> clouds) {
  std::vector<CloudRim> rims = rims_of(clouds);
  for (std::size_t c = 0; c < clouds.size(); ++c) keep_border_loops(clouds[c].loops, rims[c]);
  return rims;
}

std::vector<SewnPatch> patches_of(std::span<const CloudReport> clouds) {
  std::vector<SewnPatch> patches;
  for (const CloudReport& cloud : clouds) {
    const auto rims = std::count_if(
        cloud.loops.begin(), cloud.loops.end(),
        [](const LoopReport& loop) { return loop.match == LoopMatch::on_model && !loop.pin_hole; });
    patches.push_back({static_cast<std::size_t>(rims), cloud.replaced_groups.size()});
  }
  return patches;
}

std::vector<CloudReport> reports_of_members(std::vector<CloudReport> reports,
                                            std::span<const JoinedCloud> joined,
                                            std::size_t clouds) {
  std::vector<CloudReport> result(clouds);
  for (std::size_t j = 0; j < joined.size(); ++j) {
    const std::size_t first = joined[j].members.front();
    for (const std::size_t c : joined[j].members) {
      if (c == first) continue;
      CloudReport& report = result[c];
      report.joined_with = first;
      report.surface.rim.spacing = reports[j].surface.rim.spacing;
      report.surface.rim.median_edge = reports[j].surface.rim.median_edge;
      report.believed_shift = reports[j].believed_shift;
      report.groups = reports[j].groups;
      report.replaced_groups = reports[j].replaced_groups;
      report.margin_deg = reports[j].margin_deg;
      report.is_told_by_samples = reports[j].is_told_by_samples;
      report.is_told_by_sure_angles = reports[j].is_told_by_sure_angles;
    }
    result[first] = std::move(reports[j]);
  }
  return result;
}

std::vector<std::size_t> members_told(std::span<const CloudReport> reports, std::size_t c) {
  std::vector<std::size_t> members = {c};
  for (std::size_t other = 0; other < reports.size(); ++other) {
    if (reports[other].joined_with == c) members.push_back(other);
  }
  return members;
}

CloudPoint point_told(std::span<const CloudReport> reports,
                      std::span<const std::vector<Point>> clouds, std::size_t c, PointId p) {
  CloudPoint point{c, p.index()};
  for (std::size_t next = c + 1; point.index >= clouds[point.cloud].size(); ++next) {
    if (reports[next].joined_with != c) continue;
    point.index -= clouds[point.cloud].size();
    point.cloud = next;
  }
  return point;
}

void enter_overlap(const Overlap& overlap, CloudReport& report) {
  report.overlapping_facets = overlap.facets;
  report.overlap = overlap.figures;
  report.surface.rim.leaves_model = overlap.leaves_model;
  for (std::size_t l = 0; l < overlap.loops.size(); ++l) {
    report.loops[l].match = overlap.loops[l].match;
    report.loops[l].unmatched = overlap.loops[l].unmatched;
    report.loops[l].covered = overlap.loops[l].covered;
  }
}

void enter_shift(const Vec3& shift, const ShiftOptions& options, CloudReport& report) {
  report.shift = norm(shift);
  const bool is_too_long = options.is_too_long(report.shift, report.surface.rim.spacing);
  report.believed_shift = is_too_long ? Vec3{} : shift;
}

void enter_choice(const CloudChoice& choice, CloudReport& report) {
  report.margin_deg = choice.margin * degrees_per_radian;
  report.groups = choice.regions;
  for (const RegionVerdict& verdict : choice.regions) {
    if (verdict.under_cloud) report.replaced_groups.push_back(verdict.region);
  }
}

}  // namespace cocoon
