// Facets of the model that samples disprove: they are gone, or inside the body now.
#pragma once

#include <span>
#include <vector>

#include "geom/ids.h"
#include "update/cloud/outward_normals.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"

namespace cocoon {

// Distances in spacings of the scan.
struct DisprovedOptions {
  // A sample farther from the model than this shows a change.
  double off_model = 1.2;
  // Whether it is inside or outside tells the normal of the closest facet, if its cosine with the
  // way there is at least this.
  double min_side_cosine = 0.3;
  // It looks along its own normal: at facets by whose centroids it is at least this cosine.
  double min_cosine = 0.7;
  // If its normal is presumed it looks along the direction from which it was seen, by this cosine:
  // for the floor of a pocket the outer side of a wall that was not seen is no mouth.
  double min_presumed_cosine = 0.95;
  // Facets farther away are not looked at.
  double reach = 10;
  // A facet with a sample this near to its centroid was scanned, and is still there.
  double scanned = 1;
  // A sample this near to the way between, and at least as far above or below the one that looks,
  // is another surface before the facet.
  double shelter = 0.75;
  // The way is looked at in steps of this length, less than `shelter`. From 0.01 to 10.
  double step = 0.5;
  // The samples asked at first keep this distance. 0: all are asked.
  double apart = 2;
  // Of an island of the outside (island_spread.h) goes what is this near to disproved facets,
  double island_reach = 2.5;
  // if they are more than this share of it.
  double island_share = 0.15;
};

// What a sample off the model disproves. Between the two is what follows: nothing but air, or body.
struct Disproof {
  Point sample;
  TriangleId facet;
  bool is_air = false;  // the sample is inside the model
};

// By the samples whose normals are known: for each that disproves a facet (see below) this, in
// their order. Errors and complexity: as disproved_facets().
std::vector<Disproof> disproofs(const ModelIndex& model, const Scan& scan,
                                std::span<const Outward> outward,
                                const DisprovedOptions& options = {});

// The facets that samples off the model disprove, ascending. From a sample inside the model
// outward, and from one outside of it inward, nothing of the old surface can follow: there is air
// in front of the new surface, and body behind it. So the closest facet there is gone, or inside
// the body, if it was not scanned and no other surface of the scan lies between. Only samples whose
// normal is known are asked (others: the zero vector). At first few are; if all that these disprove
// is settled anyway (1 in `settled`), nothing is found, else all are asked. Errors: InputError for
// normals or flags of another scan or model, by their sizes, and for options out of range.
// Complexity: O(n log n) for n samples, and what NearFacets takes. Deterministic, whatever the
// order of the samples. Source: ours.
std::vector<TriangleId> disproved_facets(const ModelIndex& model, const Scan& scan,
                                         std::span<const Outward> outward,
                                         const TriangleSet& settled,
                                         const DisprovedOptions& options = {});

}  // namespace cocoon
