// Which of two closed surfaces of the same points is the rougher one?
#pragma once

#include <cstddef>

#include "geom/execution.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// How much of a closed surface needs an explanation.
struct SurfaceRoughness {
  std::size_t parts = 0;
  // 2 parts - (V - T / 2): edges and vertices where it touches itself count as well.
  std::ptrdiff_t twice_handles = 0;
  std::size_t unused_vertices = 0;  // of the triangulation

  // No more parts and handles, but some if the other has any; and no more unused vertices than
  // `unused_per_part` for each part less.
  bool is_at_most(const SurfaceRoughness& other, std::size_t unused_per_part) const {
    if (parts > other.parts || twice_handles > other.twice_handles) return false;
    if (parts == 0 && other.parts > 0) return false;
    return unused_vertices <= other.unused_vertices + unused_per_part * (other.parts - parts);
  }
};

// `vertices`: of the triangulation. Complexity: O(t) for t triangles, near linear.
SurfaceRoughness surface_roughness(const TriangleMesh& surface, std::size_t vertices,
                                   const Execution& execution = {});

}  // namespace cocoon
