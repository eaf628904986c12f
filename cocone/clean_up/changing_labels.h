// The labeling that the clean-up changes, with what it costs and where it is flawed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cocone/cell_marks.h"
#include "cocone/clean_up/far_reach.h"
#include "cocone/clean_up/label_split.h"
#include "cocone/clean_up/surface_flaws.h"
#include "cocone/clean_up_cells.h"
#include "cocone/energy/ball_cosines.h"
#include "cocone/energy/cell_energy.h"
#include "cocone/energy/doubtful_region.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// Its parts refer to each other, and steps of the clean-up to them. Who changes a label does it by
// flip(), or by hand with touch(), so that flaws are looked for again where they may have changed;
// or changes any, and calls find_flaws().
class ChangingLabels {
 public:
  // With the labels of the peel. All references must outlive the object. Complexity: that of
  // find_doubtful_region().
  ChangingLabels(const Triangulation& triangulation, const CellMarks& marks,
                 const CleanUpOptions& options, const IdVector<VertexId, CellId>* cell_at,
                 const Execution& execution);
  ChangingLabels(const ChangingLabels&) = delete;
  ChangingLabels& operator=(const ChangingLabels&) = delete;

  // Complexity: that of CellEnergy::flip().
  void flip(std::span<const CellId> cells);
  // Something has changed at the vertices of a finite cell.
  void touch(CellId c);

  // Of the region, which takes in what was touched. Complexity: that of find_surface_flaws().
  void find_flaws(const Execution& execution);
  // What costs something: pinched vertices, and wanted samples that are unused. Complexity: O(those
  // + stars of what was touched), and O(region) if something outside of the region was touched.
  std::vector<VertexId> flawed_vertices();
  // As they were found, and asked for again where something was touched since.
  const SurfaceFlaws& flaws();

  const Triangulation& triangulation;
  StarCache stars;
  IdVector<CellId, std::uint8_t> out;  // 1 = OUT
  BallCosines cosines;
  SpacingCache spacings;
  CellEnergy energy;
  DoubtfulRegion region;
  LabelSplit split;
  FarReach far_reach;

 private:
  void update_flaws();

  SurfaceFlaws flaws_;             // before what is touched_ changed
  std::vector<VertexId> touched_;  // vertices of cells that have changed sides since
};

}  // namespace cocoon
