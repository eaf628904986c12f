#include "update/orient_components.h"

#include <array>
#include <utility>

#include "geom/mesh_adjacency.h"

namespace cocoon {

namespace {

constexpr std::uint32_t no_component = 0xFFFFFFFFU;

// Whether `triangle` runs through the edge from `from` to `to` in this direction.
bool runs_through(const Triangle& triangle, VertexId from, VertexId to) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (triangle[i] == from && triangle[(i + 1) % 3] == to) return true;
  }
  return false;
}

}  // namespace

SurfaceComponents orient_components(TriangleMesh& surface) {
  // The adjacency numbers sides by corner, and corners are exchanged below: so the edges of each
  // triangle are read from this untouched copy of its corners.
  const MeshAdjacency adjacency = mesh_adjacency(surface);
  const IdVector<TriangleId, Triangle> original = surface.triangles;

  SurfaceComponents result;
  result.component_of = IdVector<TriangleId, std::uint32_t>(surface.triangles.size(), no_component);
  std::size_t doubled_conflicts = 0;  // every edge is looked at from both of its sides
  std::vector<TriangleId> queue;
  for (const TriangleId seed : surface.triangles.ids()) {
    if (result.component_of[seed] != no_component) continue;
    const std::uint32_t component = static_cast<std::uint32_t>(result.triangles.size());
    result.component_of[seed] = component;
    queue.assign(1, seed);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const TriangleId t = queue[head];
      for (std::size_t i = 0; i < 3; ++i) {
        const TriangleId across = adjacency.neighbors[t][i];
        if (across.is_none()) continue;
        const VertexId a = original[t][(i + 1) % 3];
        const VertexId b = original[t][(i + 2) % 3];
        Triangle& other = surface.triangles[across];
        const bool same_direction =
            runs_through(surface.triangles[t], a, b) == runs_through(other, a, b);
        if (result.component_of[across] == no_component) {
          if (same_direction) std::swap(other[1], other[2]);
          result.component_of[across] = component;
          queue.push_back(across);
        } else if (same_direction) {
          ++doubled_conflicts;
        }
      }
    }
    result.triangles.push_back(queue.size());
  }
  result.conflicts = doubled_conflicts / 2;
  return result;
}

}  // namespace cocoon
