// How much a rim leaves in doubt on the model: to tell which trial has found the better one.
#pragma once

#include "geom/execution.h"
#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/cut_regions.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"
#include "update/trace_border.h"

namespace cocoon {

struct RimDoubt {
  // RegionCut::doubt(): 0 where the rim is whole, and the larger the more of it is missing or
  // contradicted; 1 if it tells nothing.
  double share = 1;
  // Length of the border whose sides it tells, on the weaker side. A rim of which hardly anything
  // is known contradicts itself nowhere.
  double told = 0;
  // Whether facets would go that lie far from the box of the samples (CutOptions::box_reach).
  bool reaches_far = false;
};

// Of the cut by this rim alone. `overlap`: of the rim; loops that are not on the model have no part
// in it. `samples`: of its cloud; they are not asked for what they show.
// Errors: as trace_border() and cut_under_cloud(). Complexity: that of both. Source: ours,
// docs/departures.md.
RimDoubt rim_doubt(const ModelIndex& model, Points samples, CloudRim rim, const Overlap& overlap,
                   const TraceOptions& trace = {}, const CutOptions& cut = {},
                   const Execution& execution = {});

}  // namespace cocoon
