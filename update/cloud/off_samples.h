// Samples of a change, with the ways they face.
#pragma once

#include <span>
#include <vector>

#include "geom/point.h"
#include "update/cloud/outward_normals.h"
#include "update/model/model_index.h"

namespace cocoon {

// A sample off the model, and which way its surface faces.
struct OffSample {
  Point place;
  Outward outward;
};

// Those farther from the model than this, in their order. `outward`: of each sample; none: nothing
// is known. Complexity: as ids_off_model(). Errors: InputError for normals of other samples, by
// their number.
std::vector<OffSample> outward_samples_off_model(const ModelIndex& model, Points samples,
                                                 std::span<const Outward> outward, double distance);

}  // namespace cocoon
