// Where each vertex of an updated mesh comes from.
#pragma once

#include <cstdint>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/update_model.h"

namespace cocoon {

// A vertex of the model, or a point of a cloud.
struct VertexOrigin {
  std::uint32_t input = 0;  // 0: the model; c + 1: cloud c
  std::uint32_t index = 0;  // of the vertex or point in it

  friend bool operator==(const VertexOrigin&, const VertexOrigin&) = default;
};

// The origin of each vertex of `result.mesh` as the update made it; a caller may have added others
// behind these. Of equal points the first one: the model comes before
// the clouds, and these in the order given. Precondition: result.status is ok, and its
// reconstruction tells the point of each vertex (that of a session's update does not).
// Complexity: O(vertices of the model + points of the clouds).
IdVector<VertexId, VertexOrigin> vertex_origins(const UpdateResult& result);

}  // namespace cocoon
