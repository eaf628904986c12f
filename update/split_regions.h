// Where a rim does not cut the model in two: the region on both of its sides is split by labels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"

namespace cocoon {

struct SplitOptions {
  // Facets beside the border are seeds if their centroids lie within this many spacings of the rim
  // (those of the rim, or the facet's shortest edge if that is longer). Farther away the wedge at
  // the rim says little: the other wall of a thin slot is near, too.
  double seed_reach = 1.5;
  // The part under the clouds may reach no farther from the points of a cloud than this share of
  // the cloud's extent (diagonal of its bounding box): what lies farther away is not under it.
  double max_reach = 0.3;
};

enum class SplitStatus {
  ok,
  one_sided,  // no seeds under the clouds, or none outside them
  too_far,    // the part under the clouds reaches farther than max_reach
};

struct SplitRegion {
  RegionId outside;  // the region that was split; it keeps its number
  RegionId under;    // a new one
  std::size_t outside_seeds = 0;
  std::size_t under_seeds = 0;
  std::size_t under_facets = 0;
  std::size_t cut_edges = 0;  // model edges between the two parts: the handles are cut there
  double reach = 0;           // of the part under the clouds, as in max_reach
};

struct RegionSplit {
  SplitStatus status = SplitStatus::ok;
  std::vector<SplitRegion> split;  // in the order given, up to the one that failed
  Regions regions;                 // with the new regions behind the old ones, if ok
};

// Splits each region of `divided` in two: facets beside the border are seeds, labeled "under" or
// "outside" by the side of the nearest rim edge on which they lie; all other facets of the region
// take the label of the seed that is nearest over facets of the region, by the lengths between
// centroids. A handle between both sides is so cut about halfway. At equal lengths "outside" wins.
// The rims are those that formed the border, with their spacings; `clouds` as the rims. What it
// cannot decide is reported, not guessed: see SplitStatus.
// Errors: InputError for regions of another model, by their sizes, or that are not there, and for
// options out of range.
// Complexity: O(n log n) for n facets. Deterministic: lengths decide, never numbers of facets.
// Source: ours; Woo & Dey 2005, section 3.4 presumes rims that separate.
RegionSplit split_regions(const ModelIndex& model, const Regions& regions,
                          std::span<const RegionId> divided, std::span<const CloudRim> rims,
                          std::span<const std::vector<Point>> clouds,
                          const SplitOptions& options = {});

}  // namespace cocoon
