#include "update/steps/find_overlap.h"

#include <utility>

#include "update/checks/unit_factor.h"
#include "update/report/update_messages.h"
#include "update/steps/detect_boundaries.h"

namespace cocoon {

namespace {

void report_overlap(UpdateRun& run, std::size_t c) {
  const Overlap& overlap = run.rims.overlaps[c];
  enter_overlap(overlap, run.result.clouds[c]);
  for (std::size_t l = 0; l < overlap.loops.size(); ++l) {
    const LoopOverlap& loop = overlap.loops[l];
    if (loop.match != LoopMatch::covered) continue;  // off the model: notes_of_cloud()
    run.warn(run.name_of_loop(c, l) + ": " +
             warning_of_loop(loop.covered > 0 || !run.rims.shared_with[c].empty()));
  }
}

void fail_no_overlap(UpdateRun& run, std::size_t c, const Execution& execution) {
  const CloudReport& report = run.result.clouds[c];
  const CloudRim& rim = report.surface.rim;
  const Overlap& overlap = run.rims.overlaps[c];
  const OverlapOptions& options = run.options.overlap;
  run.fail(UpdateStatus::no_overlap,
           run.name_of_cloud(c) + " " +
               reason_of_no_overlap(overlap.unmatched, report.boundary_points, options.max_distance,
                                    rim.spacing,
                                    unit_factor(*run.index, rim, overlap, options, execution)));
}

}  // namespace

bool find_overlap(UpdateRun& run, const Execution& execution) {
  const UpdateOptions& options = run.options;
  run.rims = locate_rims(*run.index, run.clouds, run.other_surfaces, options, run.result.clouds,
                         execution);
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    CloudReport& report = run.result.clouds[c];
    if (report.surface.rim.loops.empty()) {
      fail_without_rim(run, c);
      continue;
    }
    report_overlap(run, c);
    enter_shift(cloud_shift(*run.index, run.clouds[c], report.surface.rim, run.rims.overlaps[c],
                            options.shift),
                options.shift, report);
    run.warn_of_cloud(c, warnings_of_cloud(report, options.overlap, options.shift));
    if (run.rims.overlaps[c].status == OverlapStatus::no_overlap) {
      fail_no_overlap(run, c, execution);
    }
  }
  if (run.result.status != UpdateStatus::ok) return false;
  trace_borders(run, execution);
  return true;
}

void trace_borders(UpdateRun& run, const Execution& execution) {
  run.borders.clear();
  run.whole_regions.reset();
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    CloudReport& report = run.result.clouds[c];
    Border& border = run.borders.emplace_back(trace_border(
        *run.index, report.surface.rim, run.rims.overlaps[c], run.options.trace, execution));
    TriangleSet facets = std::exchange(border.facets, {});
    if (c == 0) {
      run.border_facets = std::move(facets);
    } else {
      for (const TriangleId t : facets.ids()) run.border_facets[t] |= facets[t];
    }
    report.border = border.figures;
  }
}

}  // namespace cocoon
