// The cells around a vertex of a changing triangulation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/dynamic_delaunay.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

class StarFinder {
 public:
  // All cells that have v as a vertex, each once; valid until the next call. Precondition:
  // delaunay.contains(v). Complexity: O(star), and once O(slots).
  std::span<const CellId> star(const DynamicDelaunay& delaunay, VertexId v);

 private:
  IdVector<CellId, std::uint32_t> seen_;  // the call in which the cell was met last
  std::uint32_t call_ = 0;
  std::vector<CellId> queue_;
};

}  // namespace cocoon
