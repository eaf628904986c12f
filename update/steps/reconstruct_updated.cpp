#include "update/steps/reconstruct_updated.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geom/working_scale.h"
#include "update/disproved_facets.h"
#include "update/model/euler_number.h"
#include "update/regions/kept_surface.h"
#include "update/regions/scanned_again.h"
#include "update/regions/unchanged_rest.h"
#include "update/report/overlooked_vertices.h"
#include "update/report/update_messages.h"
#include "update/report/updated_vertices.h"
#include "update/steps/result_doubts.h"

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

// What lies amid new samples although no rim says so goes, too, if it is much; and what was neither
// scanned nor changed stays, although it lies behind a rim.
void replace(UpdateRun& run, std::span<const CloudRim> rims,
             std::span<const NearestPointTree> trees) {
  UpdateResult& result = run.result;
  const OverlookedOptions& options = run.options.overlooked;
  const auto replaced_but = [&](const SaidVertices& said) {
    return replaced_vertices(*run.index, result.regions, result.choice, rims, run.clouds,
                             run.options.replace, said);
  };
  ReplacedVertices replaced = replaced_but({});
  const std::vector<VertexId> stay =
      unchanged_rest(*run.index, replaced.removed, result.regions, result.choice,
                     run.options.overrides.replaced, run.scans(), trees, run.options.unchanged);
  result.overlooked = overlooked_vertices(*run.index, replaced.removed, rims, trees, options);
  std::vector<VertexId> go;
  if (options.go && result.overlooked.are_many(options)) {
    go = scanned_again(*run.index, result.overlooked.vertices, trees, run.outward());
    const std::vector<RegionId>& kept = run.options.overrides.kept;
    std::erase_if(go, [&](VertexId v) {
      return std::find(kept.begin(), kept.end(), result.regions.group_of_vertex[v]) != kept.end();
    });
  }
  if (!go.empty() || !stay.empty()) replaced = replaced_but({go, stay});
  result.replacement = replace_points(*run.index, std::move(replaced), run.given);
}

}  // namespace

void reconstruct_updated(UpdateRun& run, const UpdateParts& parts, const Execution& execution) {
  UpdateResult& result = run.result;
  const std::vector<CloudRim> rims = border_rims_of(result.clouds);
  const std::vector<NearestPointTree> trees = nearest_point_trees(run.clouds, execution);
  replace(run, rims, trees);
  const KeptSurface kept(*run.index, result.regions, result.choice, result.replacement,
                         add_seen(run));
  UpdatedSurface surface = parts.reconstruct(result.replacement, kept.told(), execution);
  result.reconstruction = std::move(surface.result);
  if (result.reconstruction.status == SurfaceStatus::refuted) {
    run.fail(UpdateStatus::refuted, result.reconstruction.verification.failure);
    return;
  }
  if (result.reconstruction.status != SurfaceStatus::ok) return fail_empty(run);
  result.mesh = std::exchange(result.reconstruction.mesh, {});
  result.vertex_map = updated_vertices(result.replacement, result.reconstruction);
  const std::size_t points = result.replacement.points.size();
  const std::size_t unused = result.reconstruction.unused_points;
  result.euler = euler_number(points - unused, surface.triangles);
  enter_doubts(*run.index, {run.given, run.joined, run.clouds, rims, trees}, run.options, result);
}

}  // namespace cocoon
