#include "app/arguments/surface_options.h"

#include <cmath>

#include "geom/angles.h"

namespace cocoon::app {

ReconstructOptions surface_options(const SurfaceArguments& arguments, ReconstructOptions defaults) {
  ReconstructOptions options = defaults;
  options.mode = arguments.mode;
  options.verify = arguments.verify;
  if (arguments.rho) options.boundary.rho = *arguments.rho;
  if (arguments.alpha_deg)
    options.boundary.alpha_cosine = std::cos(*arguments.alpha_deg * radians_per_degree);
  // theta is measured from the normal, the user's angle from the tangent plane.
  if (arguments.cocone_angle_deg) {
    options.cocone.cosine = std::sin(*arguments.cocone_angle_deg * radians_per_degree);
  }
  if (arguments.sharp_angle_deg) {
    options.prune.sharp_cosine = std::cos(*arguments.sharp_angle_deg * radians_per_degree);
  }
  return options;
}

double told_in_degrees(double radians) {
  constexpr double steps = 1e9;  // of a degree
  return std::round(radians / radians_per_degree * steps) / steps;
}

const char* name_of(Mode mode) { return mode == Mode::paper ? "paper" : "robust"; }

const char* name_of(RadiusMode mode) {
  return mode == RadiusMode::cocone ? "cocone" : "tangent-plane";
}

void add_parameters(JsonReport& report, const ReconstructOptions& options,
                    const std::string& part) {
  const std::string section = part.empty() ? "parameters/" : "parameters/" + part + "/";
  const RadiusMode radius = effective_options(options).boundary.radius_mode;
  report.set(section + "mode", name_of(options.mode));
  report.set(section + "rho", options.boundary.rho);
  report.set(section + "radius", name_of(radius));
  report.set(section + "alpha_deg", told_in_degrees(std::acos(options.boundary.alpha_cosine)));
  report.set(section + "cocone_angle_deg", told_in_degrees(std::asin(options.cocone.cosine)));
  report.set(section + "sharp_angle_deg", told_in_degrees(std::acos(options.prune.sharp_cosine)));
}

}  // namespace cocoon::app
