// Labels known from an old mesh where little has changed.
#pragma once

#include <vector>

#include "cocone/known_labels.h"
#include "cocone/marking/cell_label.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// A body before a change of the triangulation (kept_body.h).
struct BodyBefore {
  // OUT and IN of the finite cells that were there; unmarked: new, or infinite.
  IdVector<CellId, CellLabel> labels;
  std::vector<CellId> created;  // all cells that are new
};

// As known_labels of all known triangles of the mesh, and what is likely besides: asked where a
// cell at a vertex is new, or a triangle there is not known. At all other vertices the star and its
// triangles are as before: it is intact, and each of its cells is on the side where it was.
// `cell_at`: a cell at each vertex. Precondition: the mesh bounds the body, and each point that was
// there before is a vertex of it. Complexity: a byte of each cell and point, and the stars of
// vertices that are asked. Source: ours, docs/stages/live_update.md.
KnownLabels kept_labels(const Triangulation& triangulation,
                        const IdVector<VertexId, CellId>& cell_at, BodyBefore before,
                        const OldSurface& old, const Execution& execution = {});

}  // namespace cocoon
