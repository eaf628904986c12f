// Point location by walking.
#pragma once

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// A finite cell that contains p (or has it on its border), or an infinite cell whose hull facet p
// lies strictly beyond. Visibility walk from `start` to p: cross any facet that separates the
// current cell from p.
// Always ends, since the cells of a Delaunay triangulation are acyclic for every viewpoint, with
// the perturbation of geom/perturbation.h also for cospherical points.
// Complexity: O(n^(1/3)) steps expected for uniform points from a random start; a few from a start
// nearby. Source: Devillers, Pion & Teillaud, Walking in a triangulation (2002); Edelsbrunner 1990
// for acyclicity.
CellId locate(const IdVector<CellId, Cell>& cells, const IdVector<VertexId, Point>& points,
              const Point& p, CellId start);

}  // namespace cocoon
