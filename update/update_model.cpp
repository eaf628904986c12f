#include "update/update_model.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "geom/errors.h"
#include "update/cloud/layers.h"
#include "update/cloud/ordinary_size.h"
#include "update/joined_clouds.h"
#include "update/model/hollows.h"
#include "update/report/update_messages.h"
#include "update/stage_options.h"
#include "update/steps/choose_replaced.h"
#include "update/steps/detect_boundaries.h"
#include "update/steps/find_overlap.h"
#include "update/steps/reconstruct_updated.h"
#include "update/steps/segment_under_clouds.h"
#include "update/steps/update_run.h"

namespace cocoon {

namespace {

// Up to the choice of what goes. Returns false if the update ends before.
bool choose(UpdateRun& run, const UpdateParts& parts, const Execution& execution) {
  bool going = true;
  run_step(execution, "boundary_detection",
           [&](const Execution& nested) { going = detect_boundaries(run, nested); });
  if (!going) return false;
  run_step(execution, "overlapping_facets", [&](const Execution& nested) {
    run.index = &parts.index(nested);
    going = find_overlap(run, nested);
  });
  if (!going) return false;
  run_step(execution, "segmentation_and_selection", [&](const Execution& nested) {
    const auto angles = segment_under_clouds(run, nested);
    going = angles && choose_replaced(run, *angles, nested);
  });
  return going;
}

UpdateResult finish(UpdateRun& run, const UpdateParts& parts, const Execution& execution) {
  run_step(execution, "reconstruction",
           [&](const Execution& nested) { reconstruct_updated(run, parts, nested); });
  return run.take_result();
}

// What the rims of few samples may mend. Whether clouds lie on the model at all, and where, all of
// them tell better.
bool is_refused_for_rims(UpdateStatus status) {
  return status == UpdateStatus::no_cloud_surface || status == UpdateStatus::cloud_closed ||
         status == UpdateStatus::non_separating;
}

std::vector<std::size_t> clouds_in_layers(std::span<const std::vector<Point>> clouds,
                                          const UpdateOptions& options,
                                          const Execution& execution) {
  std::vector<std::size_t> found;
  const double spread = options.cloud.layers.spread;
  for (std::size_t c = 0; c < clouds.size() && spread > 0; ++c) {
    const FewSamples few = few_of_layers(clouds[c], spread);
    const double thickness = layer_thickness(clouds[c], few.kept, few.distance, execution);
    if (thickness >= options.crowded.min_thickness) found.push_back(c);
  }
  return found;
}

// Who does not get a result looks at no warnings.
UpdateResult with_first_warning(UpdateResult result, std::string warning) {
  result.warnings.insert(result.warnings.begin(), std::move(warning));
  if (result.status != UpdateStatus::ok) result.message += "; " + result.warnings.front();
  return result;
}

// Each cloud by itself. If their rims are refused and some lie in layers, of these few samples.
UpdateResult update_apart(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateParts& parts, const UpdateOptions& options,
                          const Execution& execution) {
  UpdateRun all(model, clouds, options);
  if (choose(all, parts, execution)) return finish(all, parts, execution);
  UpdateResult refused = all.take_result();
  if (!is_refused_for_rims(refused.status)) return refused;
  const std::vector<std::size_t> in_layers = clouds_in_layers(clouds, options, execution);
  if (in_layers.empty()) return refused;
  const std::string names = name_of_clouds(in_layers, clouds.size());
  for (const double times : options.cloud.layers.when_refused) {
    UpdateRun few(model, clouds, options);
    for (const std::size_t c : in_layers) {
      few.layers[c].first = true;
      few.layers[c].spread *= times;
    }
    if (!choose(few, parts, execution)) continue;
    return with_first_warning(finish(few, parts, execution),
                              warning_of_few_samples(names, refused.message));
  }
  refused.message += "; " + hint_of_layers(names);
  return refused;
}

// Without what takes a rim in doubt: of 466 pairs of views two became wrong by that, which were
// right each by itself.
UpdateOptions options_of_joined(UpdateOptions options) {
  options.shadow.max_unmatched_share = 0;
  options.choice.sure_margin = std::numbers::pi;
  return options;
}

}  // namespace

UpdateOptions paper_update_options() {
  UpdateOptions options;
  options.cloud.reconstruct.mode = options.reconstruct.mode = Mode::paper;
  options.overlap.rule = LocationRule::nearest_vertex_star;
  options.cloud.trim.max_edge = 0;
  options.cloud.rows.min_ratio = 0;
  options.cloud.density.min_ratio = 0;
  options.cloud.layers.spread = 0;
  options.choice.turned_away = std::numbers::pi;
  options.crowded.leave_out = false;
  return options;
}

UpdateResult update_model(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateParts& parts, const UpdateOptions& options,
                          const Execution& execution) {
  require_options("update", options);
  if (clouds.empty()) throw InputError("update: no cloud given; give at least one");
  require_ordinary_size(parts.ordinary_size ? Points() : model.points.span(), clouds);
  std::vector<JoinedCloud> joined = join_clouds(clouds, options.join);
  if (joined.empty()) {
    return update_apart(model, clouds, parts, options, execution);
  }
  const UpdateOptions strict = options_of_joined(options);
  UpdateRun together(model, clouds, std::move(joined), strict);
  if (choose(together, parts, execution)) return finish(together, parts, execution);
  const std::string why = together.take_result().message;
  return with_first_warning(update_apart(model, clouds, parts, options, execution),
                            warning_of_clouds_apart(why));
}

UpdateResult update_model(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateOptions& options, const Execution& execution) {
  std::optional<ModelIndex> index;
  const UpdateParts parts{
      [&](const Execution& nested) -> const ModelIndex& {
        return index ? *index : index.emplace(model, nested);
      },
      [&](const Replacement& replacement, const OldSurface& old, const Execution& nested) {
        ReconstructOptions surface = options.reconstruct;
        surface.keep_cavities = keeps_cavities(surface, *index);
        ReconstructResult result =
            reconstruct_tight_with_labels(replacement.points, old.labels, surface, nested);
        const std::size_t triangles = result.mesh.triangles.size();
        return UpdatedSurface{std::move(result), triangles};
      }};
  return update_model(model, clouds, parts, options, execution);
}

}  // namespace cocoon
