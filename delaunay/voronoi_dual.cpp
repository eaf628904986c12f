#include "delaunay/voronoi_dual.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/voronoi/cell_blocks.h"
#include "delaunay/voronoi/lean_dual.h"

namespace cocoon {

Dual voronoi_dual(const Triangulation& triangulation, const Execution& execution) {
  report_progress(execution, "voronoi_dual", 0);
  Dual dual;
  dual.centers.resize(triangulation.num_cells());
  const std::size_t finite = triangulation.num_finite_cells();
  std::vector<HardCenters> hard((finite + dual_grain - 1) / dual_grain);
  parallel_chunks(execution, finite, dual_grain, [&](std::size_t begin, std::size_t end) {
    CellBlock block;
    for (std::size_t first = begin; first < end; first += max_block_cells) {
      const std::size_t count = std::min(max_block_cells, end - first);
      load_new_run(triangulation, CellId(first), count, block, hard[begin / dual_grain]);
      for (std::size_t k = 0; k < count; ++k) dual.centers[CellId(first + k)] = block.center(k);
    }
  });
  append(hard, dual);
  dual.hard_centers = {};
  find_rays(triangulation, std::span(dual.centers.raw()).subspan(finite), dual, execution);
  report_progress(execution, "voronoi_dual", 1);
  return dual;
}

Point center_of(const Triangulation& triangulation, const Dual& dual, CellId c) {
  if (!dual.is_lean()) return dual.centers[c];
  if (triangulation.is_infinite(c)) return dual.rays[c.index() - triangulation.num_finite_cells()];
  return hard_center(triangulation, dual, c);
}

Point voronoi_vertex(const Triangulation& triangulation, CellId c) {
  return triangulation.is_infinite(c) ? hull_normal(triangulation, c).direction
                                      : circumcenter_of(triangulation, c).center;
}

DualEdge dual_edge(const Triangulation& triangulation, const Dual& dual, FacetId f) {
  CellId from = cell_of(f);
  CellId to = cell_of(triangulation.mirror(f));
  if (triangulation.is_infinite(from)) std::swap(from, to);
  return {center_of(triangulation, dual, from), center_of(triangulation, dual, to),
          triangulation.is_infinite(to)};
}

}  // namespace cocoon
