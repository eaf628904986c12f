// Edges of a rim along the new edge of a thin wall: seams around a corner.
#pragma once

#include <span>
#include <vector>

#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"

namespace cocoon {

// Distances in rim spacings.
struct WallEdgeOptions {
  // The scan goes on around an edge if a sample, which may be one of the rim, lies this close to
  // its middle, 0: never;
  double reach = 1.5;
  // no farther inward than this, along the surface beside the edge;
  double max_inward = 0.3;
  // and by this closer to the model, or farther from it, than the middle;
  double min_step = 0.3;
  // or if the middle is farther from the model than this: there no scan ends that can be updated.
  double off_model = 1;
  // The other side of the wall: another edge, over or under this one, so far away.
  double thinnest = 0.8;
  double thickest = 2.75;
  // "Over or under": least cosine of the way there and the surface normal at the edge; and of the
  // normals at both, whichever way they point.
  double min_way_cosine = 0.7;
  double min_normal_cosine = 0.6;
};

// Marks such edges of a rim with seams as inner ones (RimLoop::inner), and counts them
// (CloudRim::wall_edges, seam_edges); a rim without any seam is left as it is, and so is one of
// which nothing would be left. `clouds`: that of the rim, and all others. Noise is taken for a
// step: with 0.15 spacings of it one in forty edges where the scan of an unchanged thin sheet ends
// is marked, with 0.3 one in four; the others still tell. Why: where a thin wall was cut, its new
// edge is only one or two rows of samples high, and the surface of the cloud is torn along it: it
// ends along the edge on both sides of the wall. These ends lie on the old model, as those of a
// scan do, and would say that the wall goes on beyond them. They are seams (rim_seams.h), but what
// is beyond them lies around the corner. Complexity: O(samples + m log m) for the m of them near
// the rim, and what NearFacets takes for those beyond it; O(rim) without seams. Deterministic.
// Errors: InputError for options out of range. Source: ours.
void mark_wall_edges(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                     CloudRim& rim, const WallEdgeOptions& options = {});

}  // namespace cocoon
