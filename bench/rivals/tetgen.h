// TetGen as a rival: the same work on the same input, timed the way its users run it.
#pragma once

#include <cstdint>

#include "bench/rivals/timed_build.h"
#include "geom/point.h"

namespace cocoon::rivals {

// The Delaunay tetrahedra of TetGen's library call with its spatial sort, one thread. Timed: from
// TetGen's array of coordinates in memory to its array of tetrahedra, the form in which its users
// get them; the call also frees what it worked with. Not timed: filling the one array, freeing the
// other. Where points are cospherical its cells are others than CGAL's and ours, and so may be
// their number.
TimedBuild tetgen_delaunay(Points points);

// What ref::cell_set_hash says for a triangulation with the cells that TetGen finds. Not timed.
// Precondition: all points different.
std::uint64_t tetgen_cell_set_hash(Points points);

}  // namespace cocoon::rivals
