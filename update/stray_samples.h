// Samples of an added cloud that belong to no surface: stray points and clumps of them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "delaunay/delaunay.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

struct StrayOptions {
  // Of single ones, as outlier_samples() tells them. The ratio is smaller than that for bodies
  // (NoiseOptions): what is missed makes a spike, and a sample too many that goes is one of a scan
  // of a place that has others.
  std::size_t neighbors = 3;
  double outlier_ratio = 2;
  // Delaunay neighbors hang together if they are not farther apart than so many spacings of both.
  double link_ratio = 3;
  // Fewer samples that hang together than these are a small part: no surface has a rim and a middle
  // with so few. 0: none is.
  std::size_t min_part = 12;
};

struct StraySamples {
  IdVector<PointId, std::uint8_t> kept;  // per point of the cloud; equal points share their fate
  // Different points left out:
  std::size_t outliers = 0;
  std::size_t in_small_parts = 0;
  std::size_t small_parts = 0;
};

// Leaves out small parts, then outliers in rounds (outlier_rounds.h), then the small parts of the
// rest; the largest part stays, however small. What lies in a layer of noise stays, too: an open
// patch has no inside (docs/departures.md, departure 18). What is flat, or is without the strays,
// is looked at just off its plane (off_plane.h). Progress: "noise/...". Errors: InputError as
// delaunay(), but for samples in one plane; if what is left lies on one line; and for options out
// of range. Complexity: O(n log n) expected, besides the rounds. Deterministic: a function of the
// set of points. Source: outliers as in cocone/noise_filter.h; small parts are ours.
StraySamples stray_samples(Points cloud, const StrayOptions& options = {},
                           const DelaunayOptions& delaunay_options = {},
                           const Execution& execution = {});

}  // namespace cocoon
