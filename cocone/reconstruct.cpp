#include "cocone/reconstruct.h"

#include <utility>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/reconstruct_steps.h"
#include "geom/messages/require_number.h"

namespace cocoon {

ReconstructOptions effective_options(ReconstructOptions options) {
  require_options("reconstruct", options.cocone);
  require_options("reconstruct", options.boundary);
  require_options("reconstruct", options.prune);
  require_options("reconstruct", options.good_vertices);
  require_options("reconstruct", options.clean_up);
  require_shares("reconstruct",
                 {{"max_contradicted_likely", options.max_contradicted_likely},
                  {"second_look.max_conflict_share", options.second_look.max_conflict_share}});
  require_amounts("reconstruct",
                  {{"second_look.max_poor_per_sample", options.second_look.max_poor_per_sample}});
  if (options.mode == Mode::paper) {
    options.boundary.radius_mode = RadiusMode::cocone;
    options.peel.deferred_seeding = false;
    options.keep_cavities = false;
    options.clean_up.enabled = false;
  }
  if (!options.clean_up.enabled || options.boundary.radius_mode == RadiusMode::cocone) {
    options.second_look.enabled = false;
  }
  return options;
}

ReconstructOptions open_cloud_defaults() {
  ReconstructOptions options;
  options.boundary.rho = 0.3;
  options.boundary.radius_mode = RadiusMode::cocone;
  return options;
}

ReconstructResult reconstruct_tight(Points points, const ReconstructOptions& options,
                                    const Execution& execution) {
  return reconstruct_tight_with_labels(points, {}, options, execution);
}

ReconstructResult reconstruct_tight(Triangulation triangulation, Points points,
                                    const ReconstructOptions& options, const Execution& execution) {
  return reconstruct_tight_with_labels(std::move(triangulation), points, {}, options, execution);
}

ReconstructResult reconstruct_tight_with_labels(Points points, const KnownLabelsSource& known,
                                                const ReconstructOptions& options,
                                                const Execution& execution) {
  ReconstructSteps steps(points, options, execution);
  steps.triangulate();
  return steps.tight_result(known);
}

ReconstructResult reconstruct_tight_with_labels(Triangulation triangulation, Points points,
                                                const KnownLabelsSource& known,
                                                const ReconstructOptions& options,
                                                const Execution& execution) {
  ReconstructSteps steps(points, options, execution);
  steps.take(std::move(triangulation));
  return steps.tight_result(known);
}

ReconstructResult reconstruct_cocone(Points points, const ReconstructOptions& options,
                                     const Execution& execution) {
  ReconstructSteps steps(points, options, execution);
  steps.triangulate();
  steps.find_poles();
  steps.build_surface();
  steps.deliver_open_surface();
  steps.verify(false);
  return steps.take_result();
}

}  // namespace cocoon
