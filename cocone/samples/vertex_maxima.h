// Maxima, one per vertex. Each thread raises its own (geom/parallel/parallel_fold.h), and they are
// joined: the largest value stays, so it does not show who raised what. One array for all would be
// raised by exchanges, for each of which the processor waits for all that it has under way.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

class VertexMaxima {
 public:
  // All zero. O(vertices).
  explicit VertexMaxima(std::size_t num_vertices) : maxima_(num_vertices, 0.0) {}

  // O(1).
  void raise(VertexId v, double value) { raise(maxima_[v], value); }
  // value_at(k, j) at vertex j of each of `cells`. Complexity: O(cells).
  template <class ValueAt>
  void raise_corners(std::span<const Cell> cells, ValueAt value_at) {
    double* const maxima = maxima_.raw().data();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        raise(maxima[cells[k].vertices[j].index()], value_at(k, j));
      }
    }
  }
  // By those of others, of as many vertices. Complexity: O(vertices), parallel.
  void join(const VertexMaxima& others, const Execution& execution) {
    constexpr std::size_t vertices_per_chunk = std::size_t{1} << 14;
    parallel_chunks(execution, maxima_.size(), vertices_per_chunk,
                    [&](std::size_t begin, std::size_t end) {
                      for (VertexId v(begin); v.index() < end; ++v) raise(v, others.maxima_[v]);
                    });
  }

  double operator[](VertexId v) const { return maxima_[v]; }
  // What raise() looks at, one double for each vertex.
  const void* values() const { return maxima_.raw().data(); }
  IdVector<VertexId, double> take() && { return std::move(maxima_); }

 private:
  // No branch on whether it is raised, which cannot be foreseen: it is stored in any case.
  static void raise(double& maximum, double value) {
    const double known = maximum;
    maximum = known < value ? value : known;
  }

  IdVector<VertexId, double> maxima_;
};

}  // namespace cocoon
