// Rims that climb what has changed, since the scanner did not see what lies behind it.
#pragma once

#include "update/cloud_rim.h"
#include "update/overlapping_facets.h"

namespace cocoon {

// Of the longest loop of a rim; points between edges with cloud beyond them, and those that other
// clouds cover, do not count.
struct ShadowOptions {
  // No larger share of its points is unmatched (OverlapOptions). 0: no rim is taken.
  double max_unmatched_share = 0.5;
  // The others lie no farther from the model than so many spacings of the rim (their median), as
  // those of a scan that is registered well.
  double max_distance = 0.5;
};

// Has a rim lie on the model though its longest loop is off it by too many points, and returns
// true, if the other points are enough and close. The rim leaves the model then
// (Overlap::leaves_model). Why: behind a boss that was scanned from one side the rim runs over the
// boss itself, farther from the model than any rim of a whole scan. A scan that is not registered
// has points that far away, too, but hardly any of its rim lies close to the model. Precondition:
// `overlap` is that of the rim. Errors: InputError for options out of range, and for the overlap of
// another rim, by its loops. Complexity: O(points of the loop). Source: ours.
bool take_shadowed_rim(const CloudRim& rim, const ShadowOptions& options, Overlap& overlap);

}  // namespace cocoon
