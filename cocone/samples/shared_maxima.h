// Maxima, one per vertex, that several threads raise at once. The largest value stays, so the order
// in which they are raised does not show. Complexity: O(1) for each value, O(vertices) to begin.
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <utility>

#include "delaunay/triangulation.h"
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
    alone_ ? raise_alone(maxima_[v], value) : raise_beside_others(v, value);
  }
  // value_at(k, j) at vertex j of each of `cells`.
  template <class ValueAt>
  void raise_corners(std::span<const Cell> cells, ValueAt value_at) {
    if (!alone_) {
      for_each_corner(cells, [&](std::size_t k, std::size_t j, VertexId v) {
        raise_beside_others(v, value_at(k, j));
      });
      return;
    }
    double* const maxima = maxima_.raw().data();
    for_each_corner(cells, [&](std::size_t k, std::size_t j, VertexId v) {
      raise_alone(maxima[v.index()], value_at(k, j));
    });
  }
  double operator[](VertexId v) const {
    return std::atomic_ref<double>(maxima_[v]).load(std::memory_order_relaxed);
  }
  // What raise() looks at, one double for each vertex.
  const void* values() const { return maxima_.raw().data(); }
  // When all threads are done.
  IdVector<VertexId, double> take() && { return std::move(maxima_); }

 private:
  template <class Visit>
  static void for_each_corner(std::span<const Cell> cells, Visit visit) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (std::size_t j = 0; j < 4; ++j) visit(k, j, cells[k].vertices[j]);
    }
  }

  // No exchange, which makes the processor wait for all that it has under way, and no branch on
  // whether it is raised, which cannot be foreseen: it is stored in any case.
  static void raise_alone(double& maximum, double value) {
    const double known = maximum;
    maximum = known < value ? value : known;
  }

  void raise_beside_others(VertexId v, double value) {
    const std::atomic_ref<double> maximum(maxima_[v]);
    double known = maximum.load(std::memory_order_relaxed);
    while (known < value &&
           !maximum.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
  }

  mutable IdVector<VertexId, double> maxima_;  // a look at an element needs a reference to it
  bool alone_;
};

}  // namespace cocoon
