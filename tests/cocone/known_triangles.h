// What a reconstruction tells of the surface, as after an update.
#pragma once

#include <vector>

#include "cocone/known_labels.h"
#include "cocone/reconstruct.h"

namespace cocoon {

inline std::vector<KnownTriangle> triangles_of(const ReconstructResult& result) {
  std::vector<KnownTriangle> known;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    known.push_back(
        {result.point_of_vertex[a], result.point_of_vertex[b], result.point_of_vertex[c]});
  }
  return known;
}

}  // namespace cocoon
