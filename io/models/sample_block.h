// The test block of Woo & Dey 2005 (Fig. 11).
#pragma once

#include "io/sample_models.h"

namespace cocoon {

// Before: a solid block, 8 x 5 x 2, all edges rounded. After: the same with a U-shaped ridge on its
// top, joined to it by a fillet. One cloud: ridge and fillet, so that it is U-shaped and has one
// boundary loop.
SampleModelDesign block_design();

// Signed distance in the plane to the figure of the ridge: all points within the ridge's half
// width of a U, which opens towards positive x.
double block_ridge_figure(double x, double y);

}  // namespace cocoon
