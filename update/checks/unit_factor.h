// A guess at the units of a cloud that does not lie on the model.
#pragma once

#include <optional>

#include "geom/execution.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"

namespace cocoon {

// The factor from one of millimeters, centimeters, inches, feet and meters to another one by which
// the rim has to be multiplied to lie on the model; of several the one nearest to 1; none: it does
// not lie there in any of these units, or more than a fifth of its points do as they are: then the
// units are right, whatever else is wrong. `as_is`: the overlap of the rim, with these options. For
// a message only. Factors that leave the spacing of the rim more than 30 times larger or smaller
// than the median edge of the model are not tried.
// Complexity: O(t log t) and an overlapping_facets() for each factor tried. Deterministic.
// Source: ours; a scanner's units differ from those of a CAD program often enough.
std::optional<double> unit_factor(const ModelIndex& model, const CloudRim& rim,
                                  const Overlap& as_is, const OverlapOptions& options = {},
                                  const Execution& execution = {});

}  // namespace cocoon
