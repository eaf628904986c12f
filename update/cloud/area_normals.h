// Normals of the vertices of an oriented surface, weighted by area: of all triangles at a vertex,
// or of those of one part of the surface.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Unit normals of the vertices: of the sum of their triangles' normals, each as long as its
// triangle is large. Zero where the sum is zero. The triangles must be oriented. Complexity:
// O(triangles + vertices).
IdVector<VertexId, Vec3> area_normals(const TriangleMesh& mesh);

// A vertex as a corner of one of the parts that meet there.
struct VertexOfPart {
  VertexId vertex;
  std::uint32_t part = 0;

  friend auto operator<=>(const VertexOfPart&, const VertexOfPart&) = default;
};

// The same at each of `wanted` of the triangles of its part alone: parts that touch at a vertex may
// be oriented one this way, one that way. `part_of`: of each triangle; within a part the triangles
// must be oriented. Complexity: O(triangles + w log w).
std::vector<Vec3> area_normals_of_parts(const TriangleMesh& mesh,
                                        std::span<const std::uint32_t> part_of,
                                        std::span<const VertexOfPart> wanted);

}  // namespace cocoon
