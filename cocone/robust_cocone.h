// Closed surfaces from noisy points: Robust Cocone as a composition of stages.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/noise_filter.h"
#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

struct NoiseCounters {
  std::size_t clumps = 0;         // of stray samples, left out
  std::size_t clump_samples = 0;  // different points of them
  std::size_t largest_clump = 0;  // different points of it
  // Where its lexicographically smallest point was given; none if there is no clump.
  PointId largest_clump_at;
  std::size_t outliers = 0;        // different points left out as outliers
  std::size_t outlier_rounds = 0;  // until there were no more
  std::size_t spared_samples = 0;  // outliers that stay, since the surface surrounds them
  std::size_t large_cells = 0;
  std::size_t outer_cells = 0;
  std::size_t inner_cells = 0;    // large ones inside the surface of all samples
  std::size_t leaked_cells = 0;   // of these, reached from infinity if nothing holds it
  bool held = false;              // more than max_leak: held outside the surface of all samples
  std::size_t skin_samples = 0;   // touched by outer balls
  std::size_t good_samples = 0;   // not on the skin, kept since the surface surrounds them
  std::size_t layer_samples = 0;  // different points left out inside the layer
};

struct RobustSamples {
  IdVector<PointId, std::uint8_t> kept;  // per input point; equal points share their fate
  std::size_t distinct = 0;              // different points
  NoiseCounters counters;
};

// Leaves floating clumps out (noise.clump_share); then outliers, in rounds until there are none,
// and clumps again if there were any; with noise.spare_good none of the samples with one disk
// around them on the Cocone surface of all samples. Then keeps the outer skin of the rest, and with
// noise.keep_good the samples with one disk around them on the surface of the rest. Where infinity
// gets into the body (noise.max_leak), the skin is that outside the closed surface of the rest.
// `options` are for these surfaces. Everything stays if nothing is noisy.
// Progress: "noise/...". Errors: InputError as delaunay(), also if what is left is coplanar;
// for options out of range (noise_filter.h, inputs/stage_inputs.h).
// Complexity: O(n log n) expected, besides the rounds (outlier_rounds.h).
// Deterministic: a function of the set of points.
// Source: Dey & Goswami 2006; clumps, outliers, good samples and leaks are ours
// (docs/stages/noise_filter.md).
RobustSamples robust_samples(Points points, const NoiseOptions& noise = {},
                             const ReconstructOptions& options = {},
                             const Execution& execution = {});

struct RobustResult {
  // As of reconstruct_tight for all points: ids are those of the user's points, and what was left
  // out counts as unused. Counters are those of the last reconstruction, of the kept samples.
  ReconstructResult surface;
  NoiseCounters noise;
};

// robust_samples, then reconstruct_tight of what is kept. Errors, complexity and source: theirs.
RobustResult reconstruct_robust(Points points, const NoiseOptions& noise = {},
                                const ReconstructOptions& options = {},
                                const Execution& execution = {});

}  // namespace cocoon
