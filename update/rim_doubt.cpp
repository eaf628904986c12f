#include "update/rim_doubt.h"

#include <algorithm>
#include <span>

namespace cocoon {

RimDoubt rim_doubt(const ModelIndex& model, Points samples, CloudRim rim, const Overlap& overlap,
                   const TraceOptions& trace, const CutOptions& options,
                   const Execution& execution) {
  const Border border = trace_border(model, rim, overlap, trace, execution);
  keep_border_loops(overlap.loops, rim);
  TriangleSet certain(model.mesh().triangles.size(), 0);
  certain_border(model, rim, border.loops, options, certain);
  const RegionCut cut = cut_under_cloud(model, certain, std::span(&rim, 1), {}, options);
  const Scan scan{samples, rim.median_edge};
  return {.share = cut.doubt(),
          .told = rim.median_edge * std::min(cut.seeds_under, cut.seeds_outside),
          .reaches_far =
              reaches_beyond(model, members(cut.under), std::span(&scan, 1), options.box_reach)};
}

}  // namespace cocoon
