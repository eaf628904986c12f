// A changing triangulation lent to stages, for tests.
#pragma once

#include <cstddef>

#include "delaunay/dynamic_delaunay.h"
#include "delaunay/lent_delaunay.h"

namespace cocoon {

// Calls visit(triangulation): the points are its vertices, in their order. Precondition: no gaps.
template <class Visit>
void lend(DynamicDelaunay& delaunay, Visit visit) {
  IdVector<PointId, VertexId> vertex_of_point;
  for (std::size_t v = 0; v < delaunay.num_vertices(); ++v) vertex_of_point.push_back(VertexId(v));
  const LentDelaunay lent(delaunay, vertex_of_point);
  visit(*lent);
}

}  // namespace cocoon
