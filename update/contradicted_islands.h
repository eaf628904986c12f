// Regions that would stay inside a scan although its samples lie above or below them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "update/choose_regions.h"
#include "update/model_index.h"
#include "update/scan.h"
#include "update/segment_model.h"

namespace cocoon {

struct IslandOptions {
  // A sample farther from the model than this many spacings of its scan contradicts the region over
  // or under which it lies: that of the closest facet
  double off_model = 1.2;
  // among those that face the same way, by this cosine.
  double min_normal_cosine = 0.5;
  // A region is contradicted by at least so many samples,
  std::size_t min_samples = 5;
  // and by more than so many for each of its facets. Infinity: none is.
  double min_share = 0.15;
};

// The regions that stay by `choice`, border on the rim of a cloud, and are contradicted by its
// samples, in the order of ids; never the largest region that stays. Why: from one side a scanner
// sees the floor of a pocket, but not its walls, and the top of a boss, but not its foot. Then the
// loop around the mouth lies on the model as that around a hole in the scan does, and what is
// inside would stay, over the floor or in the boss. scans[c] belongs to choice.clouds[c].
// Complexity: O(1) if no such region stays; else O(samples) and what NearFacets takes.
// Deterministic. Source: ours.
std::vector<RegionId> contradicted_islands(const ModelIndex& model, const Regions& regions,
                                           const RegionChoice& choice, std::span<const Scan> scans,
                                           const IslandOptions& options = {});

}  // namespace cocoon
