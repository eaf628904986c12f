// The thresholds of Boundary: which samples lie where the cloud is too sparse or ends.
#pragma once

#include "cocone/samples/cocone_radii.h"

namespace cocoon {

struct BoundaryOptions {
  // Ratio condition. The test is relative to the local feature size, not to the spacing: a gap of
  // radius g is found roughly iff g > rho h. Closed models: 1 / 1.2. Open clouds: 0.13 to 0.3.
  double rho = 1 / 1.2;
  // Normal condition: cosine of alpha, here pi / 6.
  double alpha_cosine = 0.86602540378443865;
  // Closed models: tangent_plane (far fewer false boundary samples on thin and noisy data).
  // Open clouds: cocone (cleaner rims).
  RadiusMode radius_mode = RadiusMode::tangent_plane;
};

}  // namespace cocoon
