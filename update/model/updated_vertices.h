// Where the vertices of the model are in the updated mesh.
#pragma once

#include "cocone/reconstruct.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/replace_points.h"

namespace cocoon {

// Each vertex of the model in the mesh reconstructed from the updated points; none: replaced, or
// not on the surface. Complexity: O(vertices of the model + updated points).
IdVector<VertexId, VertexId> updated_vertices(const Replacement& replacement,
                                              const ReconstructResult& reconstruction);

// Where the vertices of clouds begin in the updated mesh: kept ones come before them; those that
// were at one place are one vertex, so the last one of the model need not be the last here.
// Complexity: O(vertices of the model).
VertexId first_vertex_of_clouds(const IdVector<VertexId, VertexId>& vertex_map);

}  // namespace cocoon
