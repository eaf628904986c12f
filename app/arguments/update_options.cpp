#include "app/arguments/update_options.h"

#include <cstdint>

#include "app/arguments/surface_options.h"

namespace cocoon::app {

UpdateOptions update_options(const SurfaceArguments& arguments) {
  UpdateOptions options = arguments.mode == Mode::paper ? paper_update_options() : UpdateOptions();
  options.cloud.reconstruct = surface_options(arguments, options.cloud.reconstruct);
  if (arguments.rho) {
    options.cloud.start.rho = *arguments.rho;
    options.cloud.finer.clear();
    options.cloud.coarser.clear();
  }
  if (arguments.alpha_deg) {
    options.cloud.start.alpha_cosine = options.cloud.reconstruct.boundary.alpha_cosine;
  }
  if (arguments.keep_crowded) options.crowded.leave_out = false;
  SurfaceArguments closed = arguments;
  closed.rho.reset();
  options.reconstruct = surface_options(closed, options.reconstruct);
  return options;
}

RegionOverrides region_overrides(const UpdateArguments& arguments) {
  RegionOverrides overrides;
  for (const std::uint32_t r : arguments.replaced_groups) overrides.replaced.emplace_back(r);
  for (const std::uint32_t r : arguments.kept_groups) overrides.kept.emplace_back(r);
  return overrides;
}

void add_update_parameters(JsonReport& report, const UpdateOptions& options) {
  add_parameters(report, options.cloud.reconstruct);
  add_parameters(report, options.reconstruct, "model");
  report.set("parameters/keep_crowded", !options.crowded.leave_out);
}

}  // namespace cocoon::app
