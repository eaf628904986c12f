// The way back from the vertices of a triangulation that changes to its points.
#pragma once

#include <cstddef>
#include <span>

#include "delaunay/renumbering.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// Known where each vertex has one point; slots without a vertex have none. Kept from one change to
// the next, so that only points behind the first place of a change are listed again. The caller
// tells of every change, or forgets all by clear(). `slots`: of vertices, after the change.
class PointsAtVertices {
 public:
  bool is_known() const { return !points_.empty(); }
  void clear() { points_.clear(); }
  // Those from `first` on. Precondition: each vertex has one point. Complexity: O(points listed).
  void list(const IdVector<PointId, VertexId>& vertex_of_point, PointId first, std::size_t slots);
  // The vertices that went. Complexity: O(removed).
  void forget(std::span<const VertexId> removed, std::size_t slots);
  // If they are known. Complexity: O(moves).
  void renumber(std::span<const Renumbering::Move> moves, std::size_t slots);
  // None: no point is known there. Precondition: is_known(). O(1).
  PointId operator[](VertexId v) const { return points_[v]; }

 private:
  IdVector<VertexId, PointId> points_;
};

}  // namespace cocoon
