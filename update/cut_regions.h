// Where the rim of a cloud is torn: the model is cut by what is left of it, and by the shortest
// lines between its stretches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/cloud_rim.h"
#include "update/model_index.h"
#include "update/segment_model.h"
#include "update/trace_border.h"
#include "update/triangle_set.h"

namespace cocoon {

struct CutOptions {
  // The way over the model under a rim edge is part of the border unless it is longer than this
  // many times the edge and a spacing: then it leads around something that has nothing to do with
  // it.
  double max_detour = 2;
  // Facets beside the border say on which side of the rim they are if their centroids lie within
  // this many spacings of it (those of the rim, or the facet's shortest edge if that is longer), as
  // in SplitOptions.
  double seed_reach = 1.5;
  // The rim does not tell its sides apart if the cut costs more than this share of what the facets
  // on its weaker side say.
  double max_doubt = 0.7;
};

// The facets under the rim edges that are known: those with both ends on the model and no cloud
// beyond them, straight ways only. loops[l] belongs to rim.loops[l].
// Complexity: O(facets of the model + facets of the border).
TriangleSet certain_border(const ModelIndex& model, const CloudRim& rim,
                           std::span<const LoopBorder> loops, const CutOptions& options = {});

// All lengths are in median edges of the cloud's surface.
struct RegionCut {
  TriangleSet under;  // 1: the facet lies under the cloud
  std::size_t under_facets = 0;
  std::size_t cut_edges = 0;  // between facets of both sides, off the border
  double cut_length = 0;      // of these
  double seeds_under = 0;     // the border's sides beside facets that say so
  double seeds_outside = 0;
  double contradicted = 0;  // of both, with the other label

  // What the cut costs as a share of what the weaker side says; 1 if it says nothing.
  double doubt() const;
};

// Labels the facets that are not in `border`. Each facet beside the border says "under the cloud"
// or "outside" by the side of the nearest rim edge on which it lies, and is believed as far as its
// edges at the border are long; a cut between two facets costs the length of their edge. The labels
// are those that cost least in all, of several the ones with the fewest facets under the cloud. So
// a whole rim is all of the cut; where a stretch of it is missing the shortest way over the model
// replaces it, and where one is in a wrong place the others outvote it. A facet of the border is
// under no cloud.
// Why: a border that is closed by walks over its gaps leads astray where the gap is long, and one
// region is then partly under the cloud and partly not; the mean angle along it decides for all.
// Complexity: that of a minimum cut of n facets, near linear. Deterministic: lengths are compared
// as integers, and the labels are unique.
// Source: ours; Woo & Dey 2005, section 3.4 presumes rims that are closed.
RegionCut cut_under_cloud(const ModelIndex& model, const TriangleSet& border, const CloudRim& rim,
                          const CutOptions& options = {});

// The regions of an update with torn rims.
struct CutRegions {
  Regions regions;
  std::vector<RegionCut> cuts;  // one for each cloud; without labels where the rim is not torn
  // Of each cloud with a torn rim: 1 for the regions under it. Empty for the others.
  std::vector<IdVector<RegionId, std::uint8_t>> under;
};

// The components of the model without the borders of all clouds, split so that each lies as a whole
// under each cloud with a torn rim, or outside: parts of regions under a cloud are new ones behind
// the others. Of torn rims the border is certain_border(), of others all of it.
// rims[c] and borders[c] belong together. Complexity: as cut_under_cloud() for each torn rim.
CutRegions cut_regions(const ModelIndex& model, std::span<const CloudRim> rims,
                       std::span<const Border> borders, const CutOptions& options = {},
                       const SegmentOptions& segment = {}, const Execution& execution = {});

}  // namespace cocoon
