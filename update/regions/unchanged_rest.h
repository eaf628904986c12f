// Which vertices of the model were neither scanned again nor changed, though a rim encloses them.
#pragma once

#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/search/nearest_point.h"
#include "update/choose_regions.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"

namespace cocoon {

struct UnchangedRestOptions {
  // All in spacings of the scan. No sample is nearer to such a vertex; 0: there are none.
  double reach = 0.9;
  // One is as near as this,
  double around = 3;
  // and of all that are as near none lies farther from the model.
  double height = 0.4;
};

// Those of `removed` (ascending), piece by piece: what hangs together over edges of the model and
// has no sample near it is unchanged if all of it is, and hangs on a region that stays, at most one
// vertex between. So nothing of a boss that was taken off is, since its top is far from all
// samples; nor the place of a boss of which only the top was seen. A rim is a chain of chords
// between samples: one of long chords cuts off an edge or a corner of the model beside which the
// scan ends.
// clouds[c]: the samples of scans[c]. Nothing of a piece stays at a facet of regions that are said
// to go. Errors: InputError if not every scan has a tree, for regions of another model, by their
// sizes, for vertices that are not ascending or not of the model, and for options out of range.
// Complexity: O(r log n) for r removed vertices, and what NearFacets takes if any comes in
// question. Deterministic. Source: ours, docs/departures.md, departure 37.
std::vector<VertexId> unchanged_rest(const ModelIndex& model, std::span<const VertexId> removed,
                                     const Regions& regions, const RegionChoice& choice,
                                     std::span<const RegionId> said_to_go,
                                     std::span<const Scan> scans,
                                     std::span<const NearestPointTree> clouds,
                                     const UnchangedRestOptions& options = {});

}  // namespace cocoon
