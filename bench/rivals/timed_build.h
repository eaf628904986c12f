// What a rival's build of a triangulation is measured by.
#pragma once

#include <cstddef>

#include "bench/stopwatch.h"

namespace cocoon::rivals {

struct TimedBuild {
  bench::Elapsed elapsed;
  std::size_t finite_cells = 0;
};

}  // namespace cocoon::rivals
