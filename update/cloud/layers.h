// Samples that lie in layers over each other, or in one.
#pragma once

#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// Samples of which at most one layer is left: those that keep `distance` (thin_points).
struct FewSamples {
  double distance = 0;
  std::vector<PointId> kept;  // increasing; empty: there are too few different samples
};

// `spread`: the distance, as a share of that to the eighth neighbor, the median; not above 0: none
// are kept. Precondition: finite points. A function of the set of points. Complexity: O(n log n).
// Source: ours.
FewSamples few_of_layers(Points samples, double spread);

// How thick the samples are that lie within `reach` of one of them, as a share of how wide: by the
// root of the ratio of the smallest to the middle principal moment; the median over the samples
// `at`. 0: all flat, or a reach that is not above 0. A finer scan of a curved surface has little
// more than that, views that are out of register have a third of their shift over `reach`. Samples
// with fewer than four others around them, or on a line with these, are not counted; 0 if none are
// left. A function of the set of samples and of `at`, whatever their order. Squares of distances
// must be in the range of double. Progress: "layer_thickness". Complexity: O(n log n) for n samples
// with few around each. Errors: InputError for samples that are not finite, and for ids that are
// not of the samples. Source: principal component analysis.
double layer_thickness(Points samples, std::span<const PointId> at, double reach,
                       const Execution& execution = {});

}  // namespace cocoon
