#include "update/steps/make_surface.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geom/working_scale.h"
#include "update/disproved_facets.h"
#include "update/model/euler_number.h"
#include "update/regions/kept_surface.h"
#include "update/report/crowded_samples.h"
#include "update/report/loose_parts.h"
#include "update/report/unexplained_handles.h"
#include "update/report/update_messages.h"
#include "update/report/updated_vertices.h"

namespace cocoon {

namespace {

bool fail_empty(UpdateRun& run) {
  const ReconstructResult& updated = run.result.reconstruction;
  const bool is_all_boundary = updated.counters.boundary_samples >= updated.vertices;
  return run.fail(UpdateStatus::empty_surface,
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

// Enters what the surface is like; returns how many handles and parts nothing explains.
std::size_t enter_faults(const Attempts& attempts, UpdateResult& result) {
  // None without a mesh: it is connected (UpdatedSurface).
  result.loose_parts = loose_parts(result.mesh, first_vertex_of_clouds(result.vertex_map));
  const std::size_t parts = result.loose_parts.count;
  // To close the openings of a model changes its Euler number, too.
  if (attempts.irregular.empty()) {
    result.unexplained_handles =
        unexplained_handles(result.clouds, result.choice.undecided_loops, result.euler_before,
                            result.euler - 2 * static_cast<std::ptrdiff_t>(parts));
  }
  return result.unexplained_handles + parts;
}

// Enters the points, without the samples with a flag, and their surface; returns its faults, none
// without a surface.
std::optional<std::size_t> attempt(const Attempts& attempts, std::span<const SampleFlags> left_out,
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
  return enter_faults(attempts, result);
}

// `faults`: of the surface of all samples.
void try_without_crowded(const Attempts& attempts, std::size_t faults, const Execution& execution) {
  UpdateRun& run = attempts.run;
  CrowdedSamples& crowded = run.result.crowded;
  const CrowdedOptions& options = run.options.crowded;
  crowded = crowded_samples(*run.index, run.result.replacement.removed, run.joined, run.given,
                            options, execution);
  if (!options.leave_out || crowded.in_layers == 0) return;
  const bool is_better = run_step(execution, "without_crowded", [&](const Execution& nested) {
    const std::optional<std::size_t> left = attempt(attempts, crowded.is_in_layers, nested);
    return left && *left < faults;
  });
  if (!is_better) attempt(attempts, {}, execution);
}

}  // namespace

bool make_surface(UpdateRun& run, const UpdateParts& parts, const ReplacedVertices& replaced,
                  std::span<const EdgeSide> irregular, const Execution& execution) {
  run.result.euler_before = euler_number(*run.index, irregular);
  const Attempts attempts{run, parts, replaced, irregular};
  const std::optional<std::size_t> faults = attempt(attempts, {}, execution);
  if (!faults) {
    const ReconstructResult& surface = run.result.reconstruction;
    if (surface.status != SurfaceStatus::refuted) return fail_empty(run);
    return run.fail(UpdateStatus::refuted, surface.verification.failure);
  }
  if (*faults > 0) try_without_crowded(attempts, *faults, execution);
  return true;
}

}  // namespace cocoon
