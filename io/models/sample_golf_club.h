// The golf club of Woo & Dey 2005 (Fig. 13).
#pragma once

#include "io/sample_models.h"

namespace cocoon {

// Before: the head of a driver, with its hosel. After: the same with an alignment mark on the
// crown, a ridge that turns into a hollow beside it. One cloud, with samples both outside and
// inside the old part.
SampleModelDesign golf_club_design();

}  // namespace cocoon
