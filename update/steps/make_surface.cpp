#include "update/steps/make_surface.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geom/id_vector.h"
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

using Flags = IdVector<PointId, std::uint8_t>;

// Enters the points, without the samples with a flag, their surface and what it is like. Returns
// whether there is one.
bool attempt(const Attempts& attempts, std::span<const Flags> left_out,
             const Execution& execution) {
  UpdateRun& run = attempts.run;
  UpdateResult& result = run.result;
  result.replacement = replace_points(*run.index, attempts.replaced, run.given, left_out);
  const KeptSurface kept(*run.index, result.regions, result.choice, result.replacement,
                         add_seen(run));
  UpdatedSurface surface = attempts.parts.reconstruct(result.replacement, kept.told(), execution);
  result.reconstruction = std::move(surface.result);
  result.mesh = std::exchange(result.reconstruction.mesh, {});
  if (result.reconstruction.status != SurfaceStatus::ok) return false;
  result.vertex_map = updated_vertices(result.replacement, result.reconstruction);
  const std::size_t points = result.replacement.points.size();
  result.euler = euler_number(points - result.reconstruction.unused_points, surface.triangles);
  // To close the openings of a model changes its Euler number, too.
  if (attempts.irregular.empty()) {
    result.unexplained_handles = unexplained_handles(result.clouds, result.choice.undecided_loops,
                                                     result.euler_before, result.euler);
  }
  // None without a mesh: it is connected (UpdatedSurface).
  result.loose_parts = loose_parts(result.mesh, first_vertex_of_clouds(result.vertex_map));
  return true;
}

std::size_t faults(const UpdateResult& result) {
  return result.unexplained_handles + result.loose_parts.count;
}

// Whether they were left out in the end.
void try_without_crowded(const Attempts& attempts, const Execution& execution) {
  UpdateResult& result = attempts.run.result;
  const CrowdedOptions& options = attempts.run.options.crowded;
  const std::size_t before = faults(result);
  result.crowded =
      crowded_samples(*attempts.run.index, result.replacement.removed, attempts.run.given, options);
  if (!options.leave_out || !result.crowded.are_in_layers(options)) return;
  const bool is_better = run_step(execution, "without_crowded", [&](const Execution& nested) {
    return attempt(attempts, result.crowded.is_closer, nested) && faults(result) < before;
  });
  if (!is_better) attempt(attempts, {}, execution);
}

}  // namespace

bool make_surface(UpdateRun& run, const UpdateParts& parts, const ReplacedVertices& replaced,
                  std::span<const EdgeSide> irregular, const Execution& execution) {
  run.result.euler_before = euler_number(*run.index, irregular);
  const Attempts attempts{run, parts, replaced, irregular};
  if (!attempt(attempts, {}, execution)) {
    const ReconstructResult& surface = run.result.reconstruction;
    if (surface.status != SurfaceStatus::refuted) return fail_empty(run);
    return run.fail(UpdateStatus::refuted, surface.verification.failure);
  }
  if (faults(run.result) > 0) try_without_crowded(attempts, execution);
  return true;
}

}  // namespace cocoon
