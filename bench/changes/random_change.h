// Design changes of parts at random, for the benchmark of changes. The unit of length is the
// spacing of the samples of the model.
#pragma once

#include <string>

#include "bench/changes/local_frame.h"
#include "geom/random/random.h"
#include "io/models/implicit_solid.h"

namespace cocoon::bench {

struct RandomChange {
  std::string name;  // of its kind; with "no " before it if it is taken back
  ImplicitSolid before;
  ImplicitSolid after;
};

// A change of `part` at a place of its surface, where `frame` has its origin and z outward. One of:
// bump, boss, rib, knob, handle, dent, pocket, slot, hole (through all), chamfer (a plane cut);
// sharp or with fillets, 2 to 8 spacings in size. Every fourth is taken back: the part is without
// it after the change.
RandomChange random_change(const ImplicitSolid& part, const LocalFrame& frame, Random& random);

}  // namespace cocoon::bench
