// The rounds of the marking (mark_cells.h) by themselves: for the peel, which discovers further
// seeds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cocone/cell_marks.h"
#include "cocone/facet_set.h"
#include "cocone/facets/half_star.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"

namespace cocoon {

class MarkingRounds {
 public:
  // All references must outlive the object.
  MarkingRounds(const Triangulation& triangulation, const FacetSet& surface, CellMarks& marks,
                const Execution& execution);

  // Runs rounds from these vertices to the end; those not good or already visited are skipped, the
  // others must touch a labeled cell. Newly labeled OUT cells are appended to `out_cells`.
  void run(std::span<const VertexId> seeds, std::vector<CellId>& out_cells);

 private:
  struct Proposal {
    CellId cell;
    CellLabel label;
  };
  bool visit(VertexId v);
  void decide(VertexId v);
  void propose(VertexId v, CellLabel flooded, CellLabel rest);
  void apply(std::vector<CellId>& out_cells);
  void append_neighbors(VertexId v, std::vector<VertexId>& frontier);

  const Triangulation& triangulation_;
  StarCache stars_;
  const FacetSet& surface_;
  CellMarks& marks_;
  HalfStar half_;
  ZeroedArray<CellId, std::uint8_t> told_;  // scratch, zero between uses: what a round proposes
  std::vector<Proposal> proposals_;
};

}  // namespace cocoon
