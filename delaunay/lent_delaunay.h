// A changing triangulation in the hands of stages that read a frozen one.
#pragma once

#include <utility>

#include "delaunay/dynamic_delaunay.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

// It is lent for as long as the object lives (DynamicDelaunay::lend), and vertex_of_point with it.
// Both come back then, whatever has been thrown. Complexity: O(input points).
class LentDelaunay {
 public:
  LentDelaunay(DynamicDelaunay& from, IdVector<PointId, VertexId>& vertex_of_point)
      : from_(from),
        vertex_of_point_(vertex_of_point),
        triangulation_(from.lend(std::move(vertex_of_point))) {}
  ~LentDelaunay() { vertex_of_point_ = from_.take_back(std::move(triangulation_)); }
  LentDelaunay(const LentDelaunay&) = delete;
  LentDelaunay& operator=(const LentDelaunay&) = delete;
  const Triangulation& operator*() const { return triangulation_; }

 private:
  DynamicDelaunay& from_;
  IdVector<PointId, VertexId>& vertex_of_point_;
  Triangulation triangulation_;
};

}  // namespace cocoon
