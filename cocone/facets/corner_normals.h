// The unit normals of triangles, many at once in SIMD lanes.
#pragma once

#include <cstddef>
#include <span>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// unit(cross(b - a, c - a)) of the corners in lexicographic order, turned as the corners run: a
// function of the points and the orientation. Where there is a next run of triangles, its points
// are asked for in advance.
// Writes those of the triangles begin .. end - 1. Complexity: O(end - begin).
void corner_normals(const IdVector<VertexId, Point>& points, std::span<const Triangle> triangles,
                    std::size_t begin, std::size_t end, std::span<Vec3> normals);

}  // namespace cocoon
