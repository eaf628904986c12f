// A changing triangulation without the gaps that changes leave.
#pragma once

#include "delaunay/dynamic_delaunay.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// The live cells and vertices, in the order of their slots, finite cells first.
struct CompactDelaunay {
  Triangulation triangulation;
  IdVector<VertexId, VertexId> vertex;  // by slot
  IdVector<CellId, CellId> cell;        // by slot
};

// `vertex_of_point`: the slot of each input point. Complexity: O(slots). The second one makes it of
// the arrays that are there.
CompactDelaunay compact_delaunay(const DynamicDelaunay& delaunay,
                                 const IdVector<PointId, VertexId>& vertex_of_point);
CompactDelaunay compact_delaunay(DynamicDelaunay&& delaunay,
                                 const IdVector<PointId, VertexId>& vertex_of_point);

}  // namespace cocoon
