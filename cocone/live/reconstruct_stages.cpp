#include "cocone/live/reconstruct_stages.h"

#include <utility>

#include "cocone/reconstruct_steps.h"

namespace cocoon {

ReconstructResult reconstruct_tight_with_labels(Triangulation triangulation, Points points,
                                                const KnownLabelsSource& known,
                                                const ReconstructOptions& options,
                                                const Execution& execution,
                                                ReconstructStages& stages) {
  ReconstructSteps steps(points, options, execution);
  steps.keep_stages(stages);
  steps.take(std::move(triangulation));
  return steps.tight_result(known);
}

ReconstructResult reconstruct_tight_from(const Triangulation& triangulation,
                                         KnownCandidates candidates, Points points,
                                         const KnownLabelsSource& known,
                                         const ReconstructOptions& options,
                                         const Execution& execution, const LiveStages& live,
                                         CoconeSurface& surface) {
  ReconstructSteps steps(points, options, execution);
  steps.use(live);
  steps.refer_to(triangulation);
  steps.extract_from(std::move(candidates));
  steps.close_surface(known);
  steps.verify(true);
  surface = steps.take_surface();
  return steps.take_result();
}

}  // namespace cocoon
