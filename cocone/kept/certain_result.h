// The result of a reconstruction from a surface that is certified.
#pragma once

#include <cstddef>

#include "cocone/kept/certified_surface.h"
#include "cocone/live/live_candidates.h"
#include "cocone/reconstruct.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// What it is told from. Precondition of all: certified.exists().
struct CertainView {
  const DynamicDelaunay& delaunay;
  const IdVector<PointId, VertexId>& vertex_of_point;
  const LiveCandidates& candidates;
  const CertifiedSurface& certified;
};

// What the result has besides mesh and vertices. Complexity: O(1).
ReconstructResult certain_counts(const CertainView& view, std::size_t points);
// The whole result. Complexity: O(n).
ReconstructResult certain_result(const CertainView& view, Points points);

}  // namespace cocoon
