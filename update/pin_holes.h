// Pin-holes of a cloud through which the model goes on: the tip of an ear that the scan left out,
// or of a finger.
#pragma once

#include <vector>

#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"

namespace cocoon {

struct PinHoleOptions {
  // All points of the hole are this close to the model, in median edges of the cloud's surface; 0:
  // none is opened. Registration may be off by half a spacing.
  double max_distance = 1;
  // The model goes on if a vertex of it that is no farther from the middle of the hole than the
  // hole's perimeter has no sample of the cloud within this many of these edges. In a hole as wide
  // as a pin-hole may be, no vertex is that lonely.
  double min_beyond = 2;
};

// The pin-holes (CloudRim::pin_hole_loops) that are rims after all, in their order.
// Why: a scan has holes of its own, so small loops are no rims as a rule (cloud_rim.h). But where
// the model sticks out through one, all of it beyond the hole would be taken to lie under the
// cloud. A place where material is gone is no such hole: there the cloud's surface is closed, and a
// hole in it is not on the model. Complexity: O(1) without pin-holes; else O(v + t) for a model of
// v vertices and t triangles, a few operations for each, and, if one of them is on the model, O(n
// log n) for the n samples. Deterministic. Errors: InputError for options out of range.
// Source: ours; Woo & Dey 2005 takes every loop for a rim.
std::vector<RimLoop> open_pin_holes(const ModelIndex& model, Points cloud, const CloudRim& rim,
                                    const PinHoleOptions& options = {});

}  // namespace cocoon
