// Maxima, one per vertex, that several threads raise at once. The largest value stays, so the order
// in which they are raised does not show.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

class SharedMaxima {
 public:
  // All zero.
  SharedMaxima(std::size_t num_vertices, const Execution& execution)
      : maxima_(num_vertices, 0.0), alone_(thread_count(execution) == 1) {}

  void raise(VertexId v, double value) {
    const std::atomic_ref<double> maximum(maxima_[v]);
    double known = maximum.load(std::memory_order_relaxed);
    if (alone_) {
      // No exchange, which makes the processor wait for all that it has under way, and no branch
      // on whether it is raised, which cannot be foreseen.
      maximum.store(std::max(known, value), std::memory_order_relaxed);
      return;
    }
    while (known < value &&
           !maximum.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
  }
  double operator[](VertexId v) const {
    return std::atomic_ref<double>(maxima_[v]).load(std::memory_order_relaxed);
  }
  // What raise() looks at, one double for each vertex.
  const void* values() const { return maxima_.raw().data(); }
  // When all threads are done.
  IdVector<VertexId, double> take() && { return std::move(maxima_); }

 private:
  mutable IdVector<VertexId, double> maxima_;  // a look at an element needs a reference to it
  bool alone_;
};

}  // namespace cocoon
