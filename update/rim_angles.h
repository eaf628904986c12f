// How the regions lie to the cloud: the mean angle at the rim between the cloud and each region.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"
#include "update/trace_border.h"

namespace cocoon {

struct AngleMean {
  double sum = 0;         // radians
  std::size_t edges = 0;  // rim edges that count for the region
  // 0 without edges: ask for these first.
  double mean() const { return edges == 0 ? 0 : sum / static_cast<double>(edges); }
};

// Of one loop.
struct RegionAngles {
  std::uint32_t cloud = 0;  // which cloud the loop belongs to; set by the caller
  IdVector<RegionId, AngleMean> regions;
  std::size_t widened = 0;  // pairs (edge, region) served by the facets around those of the edge
  // Left out: pairs whose vertex lies on the line of the edge, and edges whose apex does.
  std::size_t degenerate = 0;

  // Regions that some edge counts for. O(regions).
  std::size_t seen() const {
    return static_cast<std::size_t>(std::count_if(
        regions.begin(), regions.end(), [](const AngleMean& mean) { return mean.edges > 0; }));
  }
};

struct AngleOptions {
  // A vertex closer to the line of E_i than this share of its distance from P0 does not count.
  double min_relative_height = 1e-9;
};

// For each rim edge E_i = (P0, P1) with apex P2 and each region k near it:
//   theta_ik = angle in [0, pi] between the parts of P2 - P0 and P_k - P0 orthogonal to P1 - P0
// where P_k is the vertex of group k, among the corners of the facets under E_i, that is closest
// to the midpoint of E_i; if there is none, among the corners of the facets around those; if there
// is still none, E_i does not count for k. The result is the mean over the edges that count.
//
// The angle is that of the wedge between cloud and region: near 0 for the region under the cloud,
// near pi for the one beyond the rim. Eq. 4-5 as printed orient both triangles alike across the
// edge, which gives pi - theta; the paper's text and figures (4.45 against 173.76 degrees, the
// smaller one replaced) need the wedge.
// Errors: InputError for regions of another model or the band of another loop, by their sizes, and
// for options out of range. Complexity: O(facets under the rim * facets at a vertex).
// Deterministic: summed in rim order, ties of P_k by lexicographic coordinates.
// Source: Woo & Dey 2005, section 3.4, Eq. 4-5.
RegionAngles mean_rim_angles(const ModelIndex& model, const Regions& regions, const RimLoop& loop,
                             const LoopBorder& band, const AngleOptions& options = {});

}  // namespace cocoon
