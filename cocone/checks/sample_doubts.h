// Why samples give no surface: what they say about themselves where there is no surface to ask.
#pragma once

#include <limits>
#include <vector>

#include "cocone/checks/surface_doubts.h"
#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

struct SampleDoubts {
  double spacing = 0;  // median over the samples, of three edges (sample_spacing.h)
  // The samples farthest from others; size: their spacing. At most max_spots.
  std::vector<DoubtfulSpot> sparse;
  // The smallest r_p / h_p of a sample, and where: with that rho it would pass the ratio condition.
  // Infinite if no sample has poles on both sides.
  double least_ratio = std::numeric_limits<double>::infinity();
  Point best;
  // Median of h_p over the spacing of p, among samples with h_p > 0; 0 if there are none. On a
  // surface the distance to the medial axis, many spacings; in a volume or a layer of noise 1 or 2.
  double height = 0;
};

// What keeps these samples from being well sampled, by the options of the reconstruction that found
// no surface: it triangulates them again. Ties go to the lexicographically smaller sample.
// Errors: InputError as delaunay(). Complexity: O(n log n) expected. Deterministic: a
// function of the set of points. Source: ours, docs/stages/surface_doubts.md.
SampleDoubts sample_doubts(Points points, const ReconstructOptions& options = {},
                           const SurfaceDoubtOptions& doubts = {}, const Execution& execution = {});

}  // namespace cocoon
