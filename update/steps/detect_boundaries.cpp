#include "update/steps/detect_boundaries.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "update/report/update_messages.h"

namespace cocoon {

namespace {

// Few samples of layers look smoother by themselves. They stand for all only if these have no rim,
// if locate_rims() finds theirs far clearer, or if they are to come first.
std::vector<CloudSurface> in_order(std::vector<CloudSurface> surfaces, const LayerOptions& layers) {
  std::stable_partition(surfaces.begin(), surfaces.end(), [&](const CloudSurface& surface) {
    return surface.status == CloudStatus::ok && surface.is_layered == layers.first;
  });
  return surfaces;
}

std::vector<CloudSurface> surfaces_of_cloud(const UpdateRun& run, std::size_t c,
                                            const Execution& execution) {
  CloudSurfaceOptions options = run.options.cloud;
  options.layers = run.layers[c];
  try {
    return in_order(joined_cloud_surfaces(run.clouds[c], run.joined[c], options, execution),
                    options.layers);
  } catch (const DegenerateInput& error) {
    throw DegenerateInput(run.name_of_cloud(c) + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(run.name_of_cloud(c) + ": " + error.what());
  }
}

}  // namespace

bool detect_boundaries(UpdateRun& run, const Execution& execution) {
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    try {
      run.other_surfaces.push_back(surfaces_of_cloud(run, c, execution));
    } catch (const DegenerateInput& error) {
      if (run.joined[c].sheet.empty()) throw;
      // Of a choice of the samples.
      run.fail(UpdateStatus::no_cloud_surface, error.what());
      run.other_surfaces.emplace_back();
      continue;
    }
    std::vector<CloudSurface>& surfaces = run.other_surfaces[c];
    run.result.clouds[c] = report_of_surface(std::move(surfaces.front()));
    surfaces.erase(surfaces.begin());
    if (!run.result.clouds[c].surface.has_loops()) fail_without_rim(run, c);
  }
  return run.result.status == UpdateStatus::ok;
}

bool fail_without_rim(UpdateRun& run, std::size_t c) {
  const CloudSurface& surface = run.result.clouds[c].surface;
  const bool is_empty = surface.status == CloudStatus::no_surface;
  return run.fail(is_empty ? UpdateStatus::no_cloud_surface : UpdateStatus::cloud_closed,
                  run.name_of_cloud(c) + " " +
                      (is_empty ? "gives no surface; sample it more densely or remove noise"
                                : reason_of_closed_cloud(surface.rim)) +
                      hint_of_only_trial(run.options.cloud));
}

}  // namespace cocoon
