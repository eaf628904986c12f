#include "cocone/steps/reconstruct_and_keep.h"

#include <utility>

#include "cocone/steps/close_surface.h"
#include "cocone/steps/find_surface.h"
#include "cocone/steps/surface_result.h"

namespace cocoon {

namespace {

CoconeSurface cocone_surface(ManifoldSurface& surface, GoodUmbrellas good) {
  return {.halves = std::move(surface.halves),
          .good = std::move(good.good),
          .umbrellas = good.umbrellas,
          .first_walk = surface.first_walk};
}

}  // namespace

ReconstructResult reconstruct_and_keep(Triangulation triangulation, Points points,
                                       const KnownLabelsSource& known,
                                       const ReconstructOptions& options,
                                       const Execution& execution, ReconstructStages& stages) {
  const ReconstructOptions effective = effective_options(options);
  const ReconstructInput input{triangulation, points, effective};
  SurfaceResult made = begin_result(input);
  FoundSurface found = find_surface(input, made.result.counters, &stages, execution);
  GoodUmbrellas good = close_surface(input, found, known, {.stages = &stages}, made, execution);
  verify_result(input, SurfaceKind::closed, made, execution);
  stages.not_in_doubles = std::move(found.not_in_doubles);
  stages.poles = std::move(found.poles);
  stages.boundary = std::move(found.boundary);
  stages.marked = std::move(found.surface.triangles.set);
  stages.surface = cocone_surface(found.surface, std::move(good));
  stages.triangulation = std::move(triangulation);
  return std::move(made.result);
}

ReconstructResult reconstruct_tight_from(const Triangulation& triangulation,
                                         KnownCandidates candidates, Points points,
                                         const KnownLabelsSource& known,
                                         const ReconstructOptions& options,
                                         const Execution& execution, const LiveStages& live,
                                         CoconeSurface& surface) {
  const ReconstructOptions effective = effective_options(options);
  const ReconstructInput input{triangulation, points, effective};
  SurfaceResult made = begin_result(input);
  FoundSurface found = find_surface(input, std::move(candidates), made.result.counters, execution);
  GoodUmbrellas good = close_surface(input, found, known, {.live = &live}, made, execution);
  verify_result(input, SurfaceKind::closed, made, execution);
  surface = cocone_surface(found.surface, std::move(good));
  surface.triangles = std::move(found.surface.triangles);
  surface.rest = std::move(found.surface.rest);
  return std::move(made.result);
}

}  // namespace cocoon
