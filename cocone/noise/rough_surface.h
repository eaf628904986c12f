// The Cocone surface of all samples of a noisy cloud, to tell which of them are good, and what lies
// outside.
#pragma once

#include <cstdint>

#include "cocone/boundary_samples.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/poles.h"
#include "cocone/reconstruct.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

class RoughSurface {
 public:
  // Extracts the surface by the options of its stages. Triangulation and options must outlive the
  // object.
  // Complexity: as these stages, O(cells).
  RoughSurface(const Triangulation& triangulation, const Dual& dual,
               const ReconstructOptions& options, const Execution& execution = {});

  // 1 = one disk of the surface surrounds the sample (good_vertices); none if there is no surface.
  const VertexSet& good() const { return good_.good; }
  // Closes the surface: 1 = outside, by marking, peel and clean-up; empty if there is no surface.
  IdVector<CellId, std::uint8_t> outside(const Execution& execution = {}) const;

 private:
  const Triangulation& triangulation_;
  const ReconstructOptions& options_;
  Poles poles_;
  BoundarySamples labels_;
  LinkedFacets triangles_;
  GoodVertices good_;
};

}  // namespace cocoon
