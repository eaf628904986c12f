// Parts at random, for the benchmark of changes. The unit of length is the spacing of the samples
// of the model.
#pragma once

#include <string>

#include "geom/random/random.h"
#include "io/models/implicit_solid.h"

namespace cocoon::bench {

struct RandomPart {
  std::string name;  // of its kind
  ImplicitSolid solid;
};

// One of: block, plate, ball, cylinder, ring, bracket, tube, branches; sharp or rounded, turned at
// random, with a surface of about 2 000 to 8 000 square units. Its value is at most the distance
// from the surface.
RandomPart random_part(Random& random);

}  // namespace cocoon::bench
