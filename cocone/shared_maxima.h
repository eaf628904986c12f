// Maxima, one per vertex, that several threads raise at once. The largest value stays, so the order
// in which they are raised does not show.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "geom/ids.h"

namespace cocoon {

class SharedMaxima {
 public:
  // All zero.
  explicit SharedMaxima(std::size_t num_vertices) : maxima_(num_vertices) {}

  void raise(VertexId v, double value) {
    std::atomic<double>& maximum = maxima_[v.index()];
    double known = maximum.load(std::memory_order_relaxed);
    while (known < value &&
           !maximum.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
  }
  double operator[](VertexId v) const { return maxima_[v.index()].load(std::memory_order_relaxed); }

 private:
  std::vector<std::atomic<double>> maxima_;
};

}  // namespace cocoon
