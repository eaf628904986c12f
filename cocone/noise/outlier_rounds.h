// Outliers in rounds: when some are gone, others stand alone.
//
// What a surface surrounds is spared: beside a dense region the last row of a sparse one stands
// alone, then the row behind it, and so on, until nothing is left of it.
#pragma once

#include <cstddef>

#include "cocone/noise_filter.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// What becomes of samples that lie in one plane, as those of a face do without the strays over it.
enum class FlatSamples {
  refused,  // they are no body
  moved,    // they are a patch: looked at just off their plane (off_plane.h)
};

struct OutlierRounds {
  VertexSet out;           // 1 = left out in one of the rounds
  std::size_t count = 0;   // of these
  std::size_t spared = 0;  // samples that stay, though they are outliers of some round
  std::size_t rounds = 0;  // until there were no more, the last one included
  bool is_flat = false;    // the rounds ended since what is left lies in one plane
};

// Leaves out the first outliers (outlier_samples), then those of the triangulation of the rest, and
// so on until there are none; but never one with spared[v] = 1 (`spared` empty: all may go). The
// triangulation is used up; `spacing` (sample_spacing by options.neighbors) is its own. Asked again
// are only those that have new neighbors, or neighbors with another spacing. Complexity: O(cells)
// once, if there are outliers that go; then for each round O(k log n) expected for k cells that it
// replaces, with the stars of their vertices, on one thread. Errors: DegenerateInput if what is
// left does not span space, unless such samples are to be moved. Deterministic: a function of the
// points.
OutlierRounds outlier_rounds(Triangulation triangulation, IdVector<VertexId, double> spacing,
                             const VertexSet& first, const VertexSet& spared,
                             const NoiseOptions& options, FlatSamples flat,
                             const Execution& execution = {});

}  // namespace cocoon
