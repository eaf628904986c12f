// Which regions of the model a cloud lies over, told by its samples.
#pragma once

#include <cstdint>
#include <span>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"

namespace cocoon {

struct SampledRegionOptions {
  // The closest point of the model to a sample is its foot. A facet is covered if a foot lies on it
  // or is this close to its centroid, in spacings of the scan.
  double reach = 1.5;
  // Of a region under the samples at least this share of the area is covered,
  double min_share = 0.5;
  // and of one outside at most this.
  double max_outside_share = 0.25;
};

// A flag for each region, 1 for those of `asked` that lie under the samples; empty if these do not
// tell: if one of `asked` is covered neither enough nor little enough, or if all are, or none is.
// Why: the angles at a rim tell its sides apart where the scan goes on along the model. Where it
// ends before it meets the model, as above the foot of a boss, both sides turn away from it, and
// the smaller angle may be that of either. Without samples nothing is told. Complexity: O(facets +
// n log n) for n samples, O(log n) for each facet of the regions asked for, and what
// closest_facets() takes for the samples. Deterministic. Errors: InputError for a region that is
// not there, and for options that are no shares, or a reach below 0 or infinite. Source: ours.
IdVector<RegionId, std::uint8_t> regions_under_samples(
    const ModelIndex& model, const Regions& regions, std::span<const RegionId> asked,
    const Scan& scan, const SampledRegionOptions& options = {}, const Execution& execution = {});

}  // namespace cocoon
