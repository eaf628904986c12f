// Cells that reach far for a sample that is near the surface.
#pragma once

#include <cstdint>

#include "cocone/cell_marks.h"
#include "cocone/clean_up_cells.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// A sample that lies just beneath the surface, as the lower one of two that crowd, is no loss. A
// cell that reaches from there to the other side of the body may use it at little cost in energy,
// above all if another such sample is at its other end; but then it is a tunnel or a void.
class FarReach {
 public:
  // All references must outlive the object. `out[c]` = 1: cell c is OUT.
  FarReach(const Triangulation& triangulation, StarCache& stars, SpacingCache& spacings,
           const CellMarks& marks, const CleanUpOptions& options,
           const IdVector<CellId, std::uint8_t>& out);

  // Is a facet of the surface opposite to v in a cell no farther from v than near_surface spacings
  // of v? Its edges are no longer than stretch_ratio spacings. O(star).
  bool is_near_surface(VertexId v);
  // Has the cell a label from a good vertex, and an edge longer than stretch_ratio spacings of v?
  // Cells without one are in doubt anyway, as on parts that are sampled at their edges alone. O(1).
  bool reaches_far(CellId c, VertexId v);

 private:
  bool is_near_facet(VertexId v, FacetId f);

  const Triangulation& triangulation_;
  StarCache& stars_;
  SpacingCache& spacings_;
  const CellMarks& marks_;
  double near_surface_;
  double stretch_ratio_;
  const IdVector<CellId, std::uint8_t>& out_;
};

}  // namespace cocoon
