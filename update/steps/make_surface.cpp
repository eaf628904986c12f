#include "update/steps/make_surface.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geom/working_scale.h"
#include "update/checks/crowded_samples.h"
#include "update/checks/loose_parts.h"
#include "update/checks/patch_handles.h"
#include "update/checks/unexplained_handles.h"
#include "update/disproved_facets.h"
#include "update/model/euler_number.h"
#include "update/model/updated_vertices.h"
#include "update/regions/kept_surface.h"
#include "update/report/update_messages.h"

namespace cocoon {

namespace {

void fail_empty(UpdateRun& run) {
  const ReconstructResult& updated = run.result.reconstruction;
  const bool is_all_boundary = updated.counters.boundary_samples >= updated.vertices;
  run.fail(UpdateStatus::empty_surface,
           reason_of_empty_surface(run.result.replacement.points.size()) +
               (is_all_boundary ? hint_of_limits(run.options.reconstruct.boundary) : ""));
}

// From the samples of all clouds to facets that go. `scale`: of the coordinates.
std::vector<Sight> sights_of(const UpdateRun& run, double scale, const Execution& execution) {
  const std::vector<Scan> scans = run.scans();
  const OutwardNormals outward = run.outward();
  std::vector<Sight> sights;
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    report_progress(execution, "sights",
                    static_cast<double>(c) / static_cast<double>(scans.size()));
    if (scans[c].samples.empty()) continue;
    for (const Disproof& d :
         disproofs(*run.index, scans[c], outward(c), run.options.cut.disproved)) {
      const RegionId region = run.result.regions.region_of_facet[d.facet];
      if (!region.is_none() && run.result.choice.replaced[region] == 0) continue;
      sights.push_back({scale * d.sample, scale * run.index->centroid(d.facet), d.is_air,
                        scale * scans[c].spacing});
    }
  }
  report_progress(execution, "sights", 1);
  return sights;
}

// None if nothing is to be said to have been seen.
AddLikely add_seen(const UpdateRun& run) {
  if (run.options.sight.step == 0) return {};
  return
      [&run](const Triangulation& triangulation, KnownLabels& known, const Execution& execution) {
        const double scale = working_scale(run.result.replacement.points);
        add_seen_cells(triangulation, sights_of(run, scale, execution), run.options.sight, known);
      };
}

// What all attempts at a surface have in common.
struct Attempts {
  UpdateRun& run;
  const UpdateParts& parts;
  const ReplacedVertices& replaced;
  std::span<const EdgeSide> irregular;
};

// Enters the handles and parts that nothing explains.
void enter_unexplained(const Attempts& attempts, UpdateResult& result) {
  // None without a mesh: it is connected (UpdatedSurface).
  result.loose_parts = loose_parts(result.mesh, first_vertex_of_clouds(result.vertex_map));
  const auto parts = static_cast<std::ptrdiff_t>(result.loose_parts.count);
  // To close the openings of a model changes its Euler number, too.
  if (!attempts.irregular.empty()) return;
  result.unexplained_handles =
      unexplained_handles(patches_of(result.clouds), result.choice.undecided_loops,
                          result.euler_before, result.euler - 2 * parts);
}

// Enters the points, without the samples with a flag, and their surface; returns its triangles, or
// those that changed, none without a surface.
std::optional<std::span<const Triangle>> attempt(const Attempts& attempts,
                                                 std::span<const SampleFlags> left_out,
                                                 const Execution& execution) {
  UpdateRun& run = attempts.run;
  UpdateResult& result = run.result;
  result.replacement = replace_points(*run.index, attempts.replaced, run.given, left_out);
  const KeptSurface kept(*run.index, result.regions, result.choice, result.replacement,
                         add_seen(run));
  UpdatedSurface surface = attempts.parts.reconstruct(result.replacement, kept.told(), execution);
  result.reconstruction = std::move(surface.result);
  result.mesh = std::exchange(result.reconstruction.mesh, {});
  if (result.reconstruction.status != SurfaceStatus::ok) return {};
  result.vertex_map = updated_vertices(result.replacement, result.reconstruction);
  const std::size_t points = result.replacement.points.size();
  result.euler = euler_number(points - result.reconstruction.unused_points, surface.triangles);
  enter_unexplained(attempts, result);
  return result.mesh.triangles.empty() ? surface.changed : result.mesh.triangles.span();
}

// patch_handles() of what the samples put in. `triangles`: those of attempt().
std::vector<double> own_handles(const UpdateResult& result, std::span<const Triangle> triangles) {
  return patch_handles(vertices_of_surface(result), triangles,
                       first_vertex_of_clouds(result.vertex_map));
}

// Handles and parts of a surface.
struct Features {
  std::ptrdiff_t narrow = 0;   // handles that layers may have made,
  std::ptrdiff_t handles = 0;  // and all, but for a number that is the same for all surfaces
  std::ptrdiff_t small = 0;    // parts
  std::ptrdiff_t large = 0;
};

// `triangles`: those of attempt().
Features features(const UpdateRun& run, std::span<const Triangle> triangles) {
  const UpdateResult& result = run.result;
  const double max_width = run.options.crowded.max_width * result.crowded.depth;
  Features found;
  for (const double extent : result.loose_parts.extents) {
    ++(extent > max_width ? found.large : found.small);
  }
  const std::vector<double> lengths = own_handles(result, triangles);
  found.narrow = std::upper_bound(lengths.begin(), lengths.end(), max_width) - lengths.begin();
  found.handles = found.small + found.large - result.euler / 2;
  return found;
}

// Whether it has less of what layers make, and what else it has not is little beside that.
bool is_better(const Features& fewer, const Features& all, const CrowdedOptions& options) {
  const std::ptrdiff_t mended = all.narrow - fewer.narrow;
  const std::ptrdiff_t lost = all.handles - fewer.handles - mended;
  return fewer.narrow + fewer.small < all.narrow + all.small && fewer.large >= all.large &&
         static_cast<double>(lost) <=
             options.max_lost_share * static_cast<double>(std::max<std::ptrdiff_t>(mended, 0));
}

std::size_t unexplained(const UpdateResult& result) {
  return result.unexplained_handles + result.loose_parts.count;
}

// Where the surface of all samples, with these triangles, has handles or parts that nothing
// explains. Returns the triangles of the surface that is kept.
std::span<const Triangle> try_without_crowded(const Attempts& attempts,
                                              std::span<const Triangle> triangles,
                                              const Execution& execution) {
  UpdateRun& run = attempts.run;
  CrowdedSamples& crowded = run.result.crowded;
  const CrowdedOptions& options = run.options.crowded;
  crowded = crowded_samples(*run.index, run.result.replacement.vertices.removed, run.joined,
                            run.given, options, execution);
  if (!options.leave_out || crowded.in_layers == 0) return triangles;
  const Features all = features(run, triangles);
  if (all.narrow + all.small == 0) return triangles;
  const std::size_t before = unexplained(run.result);
  const auto of_fewer = run_step(execution, "without_crowded", [&](const Execution& nested) {
    return attempt(attempts, crowded.is_in_layers, nested);
  });
  if (of_fewer && is_better(features(run, *of_fewer), all, options)) {
    run.warn(warning_of_left_out(crowded, before, unexplained(run.result)));
    return *of_fewer;
  }
  return *attempt(attempts, {}, execution);  // there was one before
}

// Enters how many of the unexplained handles are the samples' own, and wide. `triangles`: as above.
void enter_sampled_handles(UpdateRun& run, std::span<const Triangle> triangles) {
  UpdateResult& result = run.result;
  if (result.unexplained_handles == 0) return;
  const double coarsest = largest_spacing(run.scans());
  const std::vector<double> lengths = own_handles(result, triangles);
  const auto wide = lengths.end() - std::upper_bound(lengths.begin(), lengths.end(),
                                                     run.options.handles.wide * coarsest);
  result.sampled_handles = std::min(result.unexplained_handles, static_cast<std::size_t>(wide));
}

}  // namespace

Points vertices_of_surface(const UpdateResult& result) {
  if (result.mesh.triangles.empty()) return result.replacement.points;
  return result.mesh.points.span();
}

std::optional<std::span<const Triangle>> make_surface(UpdateRun& run, const UpdateParts& parts,
                                                      const ReplacedVertices& replaced,
                                                      std::span<const EdgeSide> irregular,
                                                      const Execution& execution) {
  run.result.euler_before = euler_number(*run.index, irregular);
  const Attempts attempts{run, parts, replaced, irregular};
  auto triangles = attempt(attempts, {}, execution);
  if (!triangles) {
    const ReconstructResult& surface = run.result.reconstruction;
    if (surface.status == SurfaceStatus::refuted) {
      run.fail(UpdateStatus::refuted, surface.verification.failure);
    } else {
      fail_empty(run);
    }
    return {};
  }
  if (unexplained(run.result) > 0) {
    triangles = try_without_crowded(attempts, *triangles, execution);
    enter_sampled_handles(run, *triangles);
  }
  return triangles;
}

}  // namespace cocoon
