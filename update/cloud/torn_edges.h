// Loops beside which the scan goes on off the model: seams at the edges of a change.
#pragma once

#include <span>
#include <vector>

#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"

namespace cocoon {

// An edge is torn if a sample shows that the cloud goes on beyond it, closer to the model or
// farther from it. A loop is a seam if enough of its edges are torn. Distances in rim spacings.
struct TornEdgeOptions {
  // Largest distance of the sample from the middle of the edge.
  double reach = 1.5;
  // Its smallest distance outward from the edge, along the surface beside it.
  double min_outward = 0.2;
  // Smallest difference between its distance from the model and that of the edge's middle.
  double min_step = 0.4;
  // In a seam the share of edges that are torn or have cloud beyond them (RimLoop::inner) is
  // larger.
  double max_seam_share = 0.5;
  // In a seam the share of torn edges among those that are not inner is larger, too: a few torn
  // ones of a rim with many inner edges make no seam of it.
  double min_torn_share = 0.2;
};

// `clouds`: that of the rim, and all others. Marks loops that are seams (RimLoop::is_seam, and all
// of their edges as RimLoop::inner), and counts such edges of them (CloudRim::seam_edges,
// torn_edges). Nothing is marked if no rim would be left. Edges here and there are no seam: a rim
// may run close to what has changed. Why: where a wall meets the model at a sharp edge, as at the
// mouth of a drilled hole, the surface of the scan is torn along it. The loop that this leaves lies
// on the model, as that around a hole in the scan does; but there all samples near by lie on the
// model, too. The other side of the same tear is the upper edge of the wall: off the model, with
// samples beyond it that lie on it. Complexity: O(n) for n samples, O(m log m) for the m of them
// near the rim, and what NearFacets takes for those beyond it. Deterministic.
// Errors: InputError for options out of range. Source: ours.
void mark_torn_edges(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                     CloudRim& rim, const TornEdgeOptions& options = {});

}  // namespace cocoon
