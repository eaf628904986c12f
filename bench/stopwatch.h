// Wall-clock and processor time of a piece of work.
#pragma once

#include <chrono>
#include <ctime>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"

namespace cocoon::bench {

// On a machine with other work wall-clock time wanders by tens of percent; the processor time of
// this process (all threads, page faults included) wanders by a few. For one thread they agree on a
// quiet machine.
struct Elapsed {
  double wall = 0;  // seconds
  double processor = 0;
};

// The median of one of the two times; 0 of no runs.
inline double median(const std::vector<Elapsed>& runs, double Elapsed::*time) {
  std::vector<double> values;
  for (const Elapsed& run : runs) values.push_back(run.*time);
  return cocoon::median(std::move(values));
}

class Stopwatch {
 public:
  Elapsed elapsed() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
    return {wall.count(), static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC};
  }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  std::clock_t processor_ = std::clock();
};

}  // namespace cocoon::bench
