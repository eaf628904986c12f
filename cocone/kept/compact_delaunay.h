// A changing triangulation, and what is known of its points, without the gaps that changes leave.
#pragma once

#include "cocone/kept/certified_surface.h"
#include "cocone/kept/kept_stages.h"
#include "cocone/live/live_candidates.h"
#include "cocone/live/surface_state.h"
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

// What the stages found, in its numbers, as far as it exists: up to pruning, and from there on the
// certified surface, or marks and body that are kept; to be kept elsewhere. Complexity: O(slots).
SurfaceState surface_state(const LiveCandidates& candidates, const CertifiedSurface& certified,
                           const KeptStages& kept, const CompactDelaunay& whole);

}  // namespace cocoon
