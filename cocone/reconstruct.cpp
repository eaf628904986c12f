#include "cocone/reconstruct.h"

#include <utility>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/orient_surface.h"
#include "cocone/steps/close_surface.h"
#include "cocone/steps/find_surface.h"
#include "cocone/steps/surface_result.h"
#include "cocone/steps/triangulate_points.h"
#include "cocone/surface_mesh.h"
#include "geom/messages/require_number.h"

namespace cocoon {

namespace {

// All that follows the triangulation, which the counters are of.
ReconstructResult tight_surface(const ReconstructInput& input, const DelaunayCounters& counters,
                                const KnownLabelsSource& known, const Execution& execution) {
  SurfaceResult made = begin_result(input);
  made.result.counters.delaunay = counters;
  FoundSurface found = find_surface(input, made.result.counters, nullptr, execution);
  close_surface(input, found, known, {}, made, execution);
  verify_result(input, SurfaceKind::closed, made, execution);
  return std::move(made.result);
}

}  // namespace

void require_options(const char* stage, const ReconstructOptions& options) {
  require_options(stage, options.cocone);
  require_options(stage, options.boundary);
  require_options(stage, options.prune);
  require_options(stage, options.good_vertices);
  require_options(stage, options.clean_up);
  require_shares(stage,
                 {{"max_contradicted_likely", options.max_contradicted_likely},
                  {"second_look.max_conflict_share", options.second_look.max_conflict_share}});
  require_amounts(stage,
                  {{"second_look.max_poor_per_sample", options.second_look.max_poor_per_sample}});
}

ReconstructOptions effective_options(ReconstructOptions options) {
  require_options("reconstruct", options);
  if (options.mode == Mode::paper) {
    options.boundary.radius_mode = RadiusMode::cocone;
    options.peel.deferred_seeding = false;
    options.keep_cavities = false;
    options.clean_up.enabled = false;
  }
  options.clean_up.keep_hollows = options.keep_cavities;
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

ReconstructResult reconstruct_tight(const Triangulation& triangulation, Points points,
                                    const ReconstructOptions& options, const Execution& execution) {
  return reconstruct_tight_with_labels(triangulation, points, {}, options, execution);
}

ReconstructResult reconstruct_tight_with_labels(Points points, const KnownLabelsSource& known,
                                                const ReconstructOptions& options,
                                                const Execution& execution) {
  const ReconstructOptions effective = effective_options(options);
  const DelaunayResult built = triangulate_points(points, effective.delaunay, execution);
  return tight_surface({built.triangulation, points, effective}, built.counters, known, execution);
}

ReconstructResult reconstruct_tight_with_labels(const Triangulation& triangulation, Points points,
                                                const KnownLabelsSource& known,
                                                const ReconstructOptions& options,
                                                const Execution& execution) {
  const ReconstructOptions effective = effective_options(options);
  return tight_surface({triangulation, points, effective}, {}, known, execution);
}

ReconstructResult reconstruct_cocone(Points points, const ReconstructOptions& options,
                                     const Execution& execution) {
  const ReconstructOptions effective = effective_options(options);
  const DelaunayResult built = triangulate_points(points, effective.delaunay, execution);
  const ReconstructInput input{built.triangulation, points, effective};
  SurfaceResult made = begin_result(input);
  ReconstructCounters& counters = made.result.counters;
  counters.delaunay = built.counters;
  FoundSurface found = find_surface(input, counters, nullptr, execution);
  run_step(execution, "cocone/mesh", [&](const Execution& nested) {
    enter_mesh(input, found,
               surface_of(input.triangulation, std::exchange(found.surface.triangles, {}),
                          found.surface.halves, nested),
               made, nested);
    counters.non_orientable_components = orient_surface(made.result.mesh).non_orientable;
    canonicalize_triangles(made.result.mesh, nested);
  });
  verify_result(input, SurfaceKind::open, made, execution);
  return std::move(made.result);
}

}  // namespace cocoon
