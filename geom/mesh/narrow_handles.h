// Where a closed surface has its handles, and how narrow they are.
#pragma once

#include <cstddef>
#include <vector>

#include "geom/ids.h"
#include "geom/mesh/linked_mesh.h"

namespace cocoon {

// A closed path of edges that does not divide the surface: around a bar, or through a hole.
struct NarrowHandle {
  std::vector<VertexId> path;  // ids of the linked mesh; the last one is joined to the first
  double length = 0;           // sum of the edges, in units of the coordinates
};

// At most max_count such paths, and no more than there are handles; the shortest first. Candidates
// are the 2 g loops of a greedy homotopy basis: each joins two shortest paths from the first vertex
// of its component by one edge, and together they cut the surface open. So a loop goes around a
// handle, but is not always the shortest that does. A loop that shares more than a third of its
// vertices with shorter ones is left out, since mostly it goes around the same handle. "First", and
// ties: lexicographically; a function of the surface alone, where no two vertices are at one place.
// Precondition: each component is closed, manifold and orientable (mesh_check tells a genus).
// Coordinates of any size. Errors: InputError for vertices that are not finite.
// Complexity: O(n log n), one thread. Source: Eppstein 2003 (tree and cotree); Erickson &
// Whittlesey 2005 (shortest paths as the tree, the longest cotree); what is left out is ours.
std::vector<NarrowHandle> narrow_handles(const LinkedMesh& mesh, std::size_t max_count);

}  // namespace cocoon
