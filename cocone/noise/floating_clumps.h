// Clumps of stray samples, beside the surface or on it.
//
// Photogrammetry and mirrors leave them. Samples of a clump have neighbors as near as those of the
// body, so they are no outliers. But a clump is a heap: no disk of the Cocone surface surrounds its
// samples. On a body such bad samples lie between good ones; in a clump they lie deep among
// themselves.
#pragma once

#include <cstddef>

#include "cocone/noise_filter.h"
#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

struct FloatingClumps {
  VertexSet out;            // 1 = deep in a clump
  std::size_t clumps = 0;   // with such samples
  std::size_t samples = 0;  // such
  std::size_t largest = 0;  // the most such samples of a clump
  VertexId at;              // the lexicographically smallest of these; none if there is no clump
};

// Delaunay neighbors are linked within options.clump_link_ratio usual spacings (sample_parts.h) of
// both. A clump is what links hold together without good samples (good[v] = 1, RoughSurface): of
// more samples than options.neighbors, since fewer are outliers, and less than options.clump_share
// of all. Deep in it are those that more than options.clump_depth links part from every good one.
// No good sample goes; nothing, if there is none. Complexity: O(cells) expected. Deterministic: a
// function of the points.
FloatingClumps floating_clumps(const Triangulation& triangulation, const VertexStars& stars,
                               const IdVector<VertexId, double>& spacing, const VertexSet& good,
                               const NoiseOptions& options, const Execution& execution = {});

}  // namespace cocoon
