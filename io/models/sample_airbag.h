// The airbag of Woo & Dey 2005 (Fig. 12): the cover on a steering wheel.
#pragma once

#include "io/sample_models.h"

namespace cocoon {

// Before: a domed pad, wider at the top than at the bottom. After: with three wells sunk into its
// front, a round one for the emblem and one for switches on each side. Three clouds, one for each
// well: the change takes material away, so that all clouds but their rims lie inside the old part.
SampleModelDesign airbag_design();

}  // namespace cocoon
