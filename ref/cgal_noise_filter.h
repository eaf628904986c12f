// The noise filter of Robust Cocone a second time: on CGAL's triangulation, written for reading.
// Shares no code with the stage.
#pragma once

#include <cstdint>

#include "cocone/noise_filter.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon::ref {

enum class SampleFate : std::uint8_t {
  skin,     // a ball that the outside reaches touches it
  layer,    // none does
  outlier,  // left out before balls were looked at
};

// What the filter makes of each sample; those with spared[p] = 1 are no outliers (empty: there are
// no such). Options spare_good and keep_good are not looked at. Precondition: points are all
// different; those that are no outliers are not coplanar. Complexity: as CGAL's triangulation, for
// each round of outliers.
// Source: Dey & Goswami 2006; the outliers are ours (docs/stages/noise_filter.md).
IdVector<PointId, SampleFate> cgal_noise_filter(Points points, const NoiseOptions& options = {},
                                                const IdVector<PointId, std::uint8_t>& spared = {});

}  // namespace cocoon::ref
