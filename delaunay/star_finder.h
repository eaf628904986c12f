// The cells around vertices of a changing triangulation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/dynamic_delaunay.h"
#include "delaunay/triangulation_view.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

class StarFinder {
 public:
  // All cells that have one of the vertices, each once; valid until the next call. Precondition:
  // the vertices are in the triangulation. Complexity: O(cells found), and once O(slots).
  std::span<const CellId> stars(const DynamicDelaunay& delaunay,
                                std::span<const VertexId> vertices) {
    return stars(delaunay.view(), delaunay.cells_at_vertices(), vertices);
  }
  // The same of a triangulation with a cell at each vertex, by slot.
  std::span<const CellId> stars(const TriangulationView& view,
                                const IdVector<VertexId, CellId>& cell_at,
                                std::span<const VertexId> vertices);

 private:
  IdVector<CellId, std::uint8_t> seen_;       // 0 between calls
  IdVector<VertexId, std::uint8_t> in_list_;  // likewise
  std::vector<CellId> cells_;
};

}  // namespace cocoon
