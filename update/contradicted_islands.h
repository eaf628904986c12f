// Regions that would stay inside a scan although its samples lie above or below them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "update/choose_regions.h"
#include "update/cloud/outward_normals.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"

namespace cocoon {

// A sample off the model contradicts the region over or under which it lies. Distances in spacings
// of the sample's scan.
struct IslandOptions {
  // Smallest distance of such a sample from the model.
  double off_model = 1.2;
  // It lies over or under a facet if the cosine of the way to it and the facet's normal is at least
  // this, and no facet between faces the same way by as much.
  double min_normal_cosine = 0.5;
  // Fewest samples that contradict a region together.
  std::size_t min_samples = 5;
  // For each facet of a contradicted region there are more of them than this. Infinity: no region
  // is contradicted.
  double min_share = 0.15;
  // What is farther from all places over or under which such samples lie stays.
  double reach = 2.5;
  // A sample whose surface faces the region, as that under an arch, leaves room between: nothing
  // farther off contradicts what is this close to its foot. 0: it may.
  double facing_reach = 1.5;
};

struct ContradictedIsland {
  RegionId region;  // that stayed
  RegionId part;    // of it that goes: all of it, or a new region

  friend bool operator==(const ContradictedIsland&, const ContradictedIsland&) = default;
};

// The regions that stay by `choice`, border on the rim of a cloud, and are contradicted by its
// samples; never the largest region that stays. What of such a region is far from all places over
// or under which samples lie, in the shadow of a boss, still stays: then the other part becomes a
// region of its own, behind the others. Each cloud contradicts by itself, and what goes of a region
// is near such places of any that does. Result: by region. Why: from one side a scanner sees the
// floor of a pocket, but not its walls, and the top of a boss, but not its foot. Then the loop
// around the mouth lies on the model as that around a hole in the scan does, and what is inside
// would stay, over the floor or in the boss. Floor and top face as the region does. A sample that
// faces the region, as on the lower side of an arch, shows that there is room between: it
// contradicts nothing, nor does what lies behind it. Without `outward` nobody knows which way
// samples face. scans[c] belongs to choice.clouds[c]. Errors: InputError for parts of another
// model, by their sizes, and for options out of range. Complexity: O(regions) if no such region
// stays; else O(samples log(samples)), what NearFacets takes and, for the parts, O(triangles +
// vertices). Deterministic. Source: ours.
std::vector<ContradictedIsland> part_contradicted_islands(
    const ModelIndex& model, const RegionChoice& choice, std::span<const Scan> scans,
    Regions& regions, const IslandOptions& options = {}, const OutwardNormals& outward = {});

// Has the part go: clouds that saw the region saw the part under them. Precondition:
// `choice.replaced` has an entry for the part. Complexity: O(verdicts).
void choose_island(const ContradictedIsland& island, RegionChoice& choice);

}  // namespace cocoon
