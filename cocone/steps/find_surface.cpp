#include "cocone/steps/find_surface.h"

#include <utility>

#include "cocone/candidate_triangles.h"
#include "cocone/cocones.h"
#include "cocone/prune_sharp_edges.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

namespace {

// Enters poles and boundary samples; returns the cocones.
Cocones find_samples(const ReconstructInput& input, FoundSurface& found,
                     ReconstructCounters& counters, const Execution& execution) {
  const Triangulation& triangulation = input.triangulation;
  const ReconstructOptions& options = input.options;
  DualAndPoles first = run_step(execution, "poles", [&](const Execution& nested) {
    return dual_and_poles(triangulation, options.cocone.cosine, nested);
  });
  found.poles = std::move(first.poles);
  Cocones cocones = run_step(execution, "cocone/cones", [&](const Execution& nested) {
    return intersect_cocones(triangulation, std::move(first.sides), nested);
  });
  found.boundary = run_step(execution, "boundary", [&](const Execution& nested) {
    return boundary_samples(triangulation, first.dual, found.poles, cocones, options.boundary,
                            nested);
  });
  found.not_in_doubles = std::move(first.dual.not_in_doubles);
  counters.exact_centers = first.dual.exact_centers;
  counters.dual_facet_fallbacks = first.dual.facet_fallbacks;
  counters.hull_vertices = found.poles.hull_vertices;
  counters.degenerate_poles = found.poles.degenerate_vertices;
  counters.boundary_samples = found.boundary.count;
  counters.ratio_failed = found.boundary.ratio_failed;
  counters.recovered_samples = found.boundary.recovered;
  return cocones;
}

// The manifold of the candidates.
ManifoldSurface find_facets(const ReconstructInput& input, Cocones cocones,
                            const VertexSet& boundary, ReconstructCounters& counters,
                            ReconstructStages* stages, const Execution& execution) {
  const Triangulation& triangulation = input.triangulation;
  CandidateTriangles candidates =
      list_candidate_triangles(triangulation, cocones, boundary, execution);
  cocones = {};
  if (stages != nullptr) stages->candidates = candidates.set;
  PrunedCandidates pruned =
      prune_sharp_edges(triangulation, std::move(candidates), input.options.prune, execution);
  if (stages != nullptr) stages->left = pruned.left.set;
  ManifoldSurface surface =
      extract_manifold(triangulation, std::move(pruned.left), pruned.umbrella, execution);
  counters.candidates = pruned.candidates;
  counters.pruned = pruned.pruned;
  counters.umbrellas = pruned.umbrellas;
  if (stages != nullptr) stages->umbrella = std::move(pruned.umbrella);
  return surface;
}

void count_surface(const ManifoldSurface& surface, ReconstructCounters& counters) {
  counters.surface_triangles = surface.halves.size();
  counters.surface_walks = surface.walks;
  counters.back_contacts = surface.back_contacts;
}

}  // namespace

FoundSurface find_surface(const ReconstructInput& input, ReconstructCounters& counters,
                          ReconstructStages* stages, const Execution& execution) {
  FoundSurface found;
  Cocones cocones = find_samples(input, found, counters, execution);
  if (stages == nullptr) found.poles.heights = {};
  found.surface = run_step(execution, "cocone/surface", [&](const Execution& nested) {
    return find_facets(input, std::move(cocones), found.boundary.boundary, counters, stages,
                       nested);
  });
  count_surface(found.surface, counters);
  return found;
}

FoundSurface find_surface(const ReconstructInput& input, KnownCandidates known,
                          ReconstructCounters& counters, const Execution& execution) {
  FoundSurface found;
  counters = known.counters;
  found.poles.normals = std::move(known.normals);
  found.boundary.boundary = std::move(known.boundary);
  found.boundary.count = counters.boundary_samples;
  found.surface = run_step(execution, "cocone/surface", [&](const Execution& nested) {
    return extract_again(input.triangulation, std::move(known.left), known.umbrella,
                         known.first_walk, nested);
  });
  count_surface(found.surface, counters);
  return found;
}

}  // namespace cocoon
