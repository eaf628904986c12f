// Triangles of the model that an update loses though nothing was scanned there: a sign that the
// model is no dense sampling of its surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/triangle_mesh.h"
#include "update/mesh_change.h"

namespace cocoon {

struct LostTriangles {
  std::size_t staying = 0;       // triangles of the model all of whose vertices stay
  double staying_area = 0;       // theirs
  std::vector<TriangleId> lost;  // those of them that the updated mesh does not have, ascending
};

// The updated mesh is made from points alone. Where these sample the model's surface densely it has
// the model's triangles again, but for some at the rim of the change, and where four samples on one
// circle have another diagonal. `change` leads from the model to the updated mesh.
// Complexity: O(t). Source: ours.
LostTriangles lost_triangles(const TriangleMesh& model, const MeshChange& change);

// The area of those triangles whose middles are off the updated mesh, by more than `tolerance` of
// their longest sides, in squares of the coordinates' unit: from the few vertices of a mesh with
// large triangles, as CAD programs give, another shape is made. Complexity: O(t log t).
// Precondition: `updated` has triangles. Source: ours.
double astray_area(const TriangleMesh& model, std::span<const TriangleId> triangles,
                   const TriangleMesh& updated, double tolerance = 0.05);

}  // namespace cocoon
