#include "update/steps/reconstruct_updated.h"

#include <utility>
#include <vector>

#include "update/model/euler_number.h"
#include "update/regions/kept_surface.h"
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

}  // namespace

void reconstruct_updated(UpdateRun& run, const UpdateParts& parts, const Execution& execution) {
  UpdateResult& result = run.result;
  const std::vector<CloudRim> rims = border_rims_of(result.clouds);
  result.replacement = replace_points(*run.index, result.regions, result.choice, rims, run.clouds,
                                      run.given, run.options.replace);
  const std::vector<NearestPointTree> trees = nearest_point_trees(run.clouds, execution);
  const KeptSurface kept(*run.index, result.regions, result.choice, result.replacement);
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
