// A part of a changing triangulation as a triangulation of its own, for stages that look at stars.
#pragma once

#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/star_finder.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

// All cells at the core vertices, and no others. Whatever a stage computes from the star of a
// vertex, or from the stars of a facet's or edge's vertices, it computes here for the core as in
// the whole. Facets at the rim, which have no core vertex, have no cell behind them: they are their
// own mirrors, and what a stage says of them, and of vertices off the core, means nothing.
struct LocalPatch {
  Triangulation triangulation;                   // cells: finite ones first
  IdVector<CellId, CellId> slot_of_cell;         // in the DynamicDelaunay
  IdVector<VertexId, VertexId> vertex_in_whole;  // its id in the DynamicDelaunay
  VertexSet is_core;                             // 1 = its star is complete
};

class PatchBuilder {
 public:
  // Precondition: the vertices are in the triangulation; each once.
  // Complexity: O(cells at the core), and once O(slots).
  LocalPatch build(const DynamicDelaunay& delaunay, std::span<const VertexId> core);

 private:
  StarFinder stars_;
  // Scratch by slot; `none` between uses.
  IdVector<CellId, CellId> cell_here_;
  IdVector<VertexId, VertexId> vertex_here_;
  std::vector<CellId> slots_;
  std::vector<CellId> infinite_;
};

}  // namespace cocoon
