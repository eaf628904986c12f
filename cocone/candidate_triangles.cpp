#include "cocone/candidate_triangles.h"

#include <utility>

namespace cocoon {

namespace {
constexpr std::size_t cells_per_chunk = 16384;
}

FacetSet candidate_triangles(const Triangulation& triangulation, const Cocones& cocones,
                             const VertexSet& boundary, const Execution& execution) {
  report_progress(execution, "candidate_triangles", 0);
  const std::size_t count = triangulation.num_cells();
  IdVector<CellId, std::uint8_t> flags(count, 0);
  parallel_chunks(execution, count, cells_per_chunk, [&](std::size_t begin, std::size_t end) {
    for (CellId c(begin); c.index() < end; ++c) {
      if (cocones.meets[c] == 0) continue;
      const Cell& cell = triangulation.cell(c);
      unsigned interior = 0;  // bit i: vertex i votes
      for (unsigned i = 0; i < (triangulation.is_infinite(c) ? 3U : 4U); ++i) {
        interior |= (boundary[cell.vertices[i]] == 0 ? 1U : 0U) << i;
      }
      unsigned candidates = 0;
      for (int i = 0; i < 4; ++i) {
        const unsigned voters = interior & ~(1U << i);
        const unsigned row = cocones.row(facet_id(c, i));
        if (voters != 0 && (voters & ~row) == 0) candidates |= 1U << i;
      }
      flags[c] = static_cast<std::uint8_t>(candidates);
    }
  });
  report_progress(execution, "candidate_triangles", 1);
  return FacetSet(std::move(flags));
}

}  // namespace cocoon
