// Facets of the model near samples the nearest of which does not lie on them: they are not what was
// scanned.
#pragma once

#include <span>

#include "geom/ids.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"

namespace cocoon {

// Distances from the centroid of a facet, in spacings of the scan.
struct UnconfirmedOptions {
  // The nearest sample confirms the facet if it is no farther away,
  double reach = 1;
  // and no farther above or below the facet's plane.
  double height = 0.3;
  // If there is none so near nothing is known of the facet: it may lie in a shadow of the scanner.
  double near = 3;
};

// 1 for those of `asked` that are near samples of some scan, but not confirmed by any, where the
// samples belong (Scan::shift). Errors: InputError for options out of range. Complexity: O(facets
// of the model) for the flags, and O((n + k) log n) for n samples and k facets asked.
// Deterministic, whatever the order of samples and facets. Source: ours.
TriangleSet unconfirmed_facets(const ModelIndex& model, std::span<const Scan> scans,
                               std::span<const TriangleId> asked,
                               const UnconfirmedOptions& options = {});

}  // namespace cocoon
