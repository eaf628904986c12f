// The samples of a cloud, and how far apart they lie.
#pragma once

#include "geom/point.h"

namespace cocoon {

struct Scan {
  Points samples;      // a view: who owns them must outlive it
  double spacing = 0;  // of the samples: the median edge of their surface
  Vec3 shift = {};     // how far they are out of register, if that is known (rim_shift())
};

}  // namespace cocoon
