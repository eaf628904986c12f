// Points drawn one by one, where a list of them (test_clouds.h) does not serve.
#pragma once

#include "geom/point.h"
#include "geom/random/random.h"

namespace cocoon {

// In a cube, x drawn first.
inline Point random_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high);
  const double y = random.uniform(low, high);
  return {x, y, random.uniform(low, high)};
}

}  // namespace cocoon
