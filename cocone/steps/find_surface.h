// The steps that both reconstructions share: from the poles to the Cocone surface.
#pragma once

#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/extract_manifold.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/poles.h"
#include "cocone/reconstruct.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// What every step reads.
struct ReconstructInput {
  const Triangulation& triangulation;  // of working_scale(points) times the points
  Points points;
  const ReconstructOptions& options;  // effective_options()
};

// What find_surface() has found. What follows may take parts of it.
struct FoundSurface {
  Poles poles;
  BoundarySamples boundary;
  ManifoldSurface surface;
  std::vector<CellId> not_in_doubles;  // of the dual, whose centers nobody asks for any more
};

// Poles, cocones, boundary samples, candidates, pruning and the walk, one after the other. Enters
// what they count. `stages`, if there are any, get the candidates before and after pruning, with
// the umbrellas; else nobody will ask for the heights of the poles, and they are not kept.
// Errors, complexity and progress: those of the stages (reconstruct.h). Source: Woo & Dey 2005,
// sections 2.1, 2.2.
FoundSurface find_surface(const ReconstructInput& input, ReconstructCounters& counters,
                          ReconstructStages* stages, const Execution& execution);

// The same where all up to pruning is known: only the walk is left.
FoundSurface find_surface(const ReconstructInput& input, KnownCandidates known,
                          ReconstructCounters& counters, const Execution& execution);

}  // namespace cocoon
