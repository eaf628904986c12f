// Labels told by a foreign mesh yield to good vertices where they do not fit.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cocone/marking/cell_label.h"
#include "cocone/surface_mesh.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// The vertices of the triangulation at which the surface touches itself: ends of edges with more
// than two triangles, and vertices at which it is more than one disk; increasing. Complexity: that
// of mesh_check().
std::vector<VertexId> touching_vertices(const SurfaceMesh& surface,
                                        const Execution& execution = {});

// Forgets labels of cells with a good vertex, if a corner of theirs is within `rings` cells of one
// of the vertices `at` (0: if it is one of these). Returns how many cells had a label. Errors:
// InputError for parts of another triangulation, by their sizes. Complexity: O(cells * (1 +
// rings)).
std::size_t yield_labels(const Triangulation& triangulation, std::span<const VertexId> at,
                         unsigned rings, const VertexSet& good,
                         IdVector<CellId, CellLabel>& labels);

}  // namespace cocoon
