// Which parts of a rim are not where the cloud ends, but seams inside it.
#pragma once

#include <cstddef>

#include "geom/point.h"
#include "update/cloud_rim.h"

namespace cocoon {

struct RimSeamOptions {
  // A rim edge has cloud beyond it if, of all samples, the nearest one to the point one spacing
  // outward from its midpoint, in the plane of its triangle, is within `reach` spacings and no end.
  double reach = 0.85;
  // And if so many samples, its ends left out, are within `few_reach` spacings of that point: the
  // rim of a grid leaves out the sample at its corner, behind which there is nothing. Such edges
  // count as CloudRim::lone_edges.
  std::size_t min_samples = 2;
  double few_reach = 1.5;
  // A loop with a larger share of such edges is a seam: it is taken out of the rim, unless the
  // cloud ends along some of it.
  double max_seam_share = 0.5;
  // It does where this many edges in a row have no cloud beyond them, if such stretches together
  // are as long as min_rim_length median edges of the surface (shorter ones are pin-holes): then
  // they are the rim, and all other edges of the loop count as inner ones. 0: it never does.
  std::size_t min_rim_run = 4;
  double min_rim_length = 12;
};

// Marks the edges of each loop that have cloud beyond them (RimLoop::inner), takes out the loops
// that are seams altogether and counts both. Pin-holes that are seams go, too, and count nowhere;
// their spacing is the median edge of the surface. Edges are counted as they are, before stretches
// of a loop are told from its seams. `cloud`: that of the rim. Why: at sharp edges no spacing is
// dense enough for Cocone. Its surface breaks up along them, and the seams are rims like any other,
// but the samples beyond them belong to the same cloud. Measured on scans of parts with sharp
// edges: 0 to 30 % such edges on loops where the cloud ends, 55 to 100 % on seams. But a seam that
// runs into the rim is one loop with it, and where the surface is torn from one side to the other,
// that is the only rim there is. Complexity: O(cloud + rim log(rim)). Deterministic. Source: ours;
// Woo & Dey 2005, section 3.2 takes every loop of boundary edges. Errors: InputError for options
// out of range.
void mark_rim_seams(Points cloud, CloudRim& rim, const RimSeamOptions& options = {});

// Where cloud beyond edge i would lie: one spacing outward from its middle, in the plane of its
// triangle.
Point place_beyond(const RimLoop& loop, std::size_t i, double spacing);

}  // namespace cocoon
