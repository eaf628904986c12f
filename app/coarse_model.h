// Models whose triangles are too large for their scans, as CAD programs give them: an update makes
// the new mesh from points alone, and from few vertices it makes another shape.
#pragma once

#include "app/job.h"
#include "app/update_input.h"
#include "app/updating.h"
#include "update/update_model.h"

namespace cocoon::app {

struct CoarseModelOptions {
  // A triangle is large if longer than this many spacings of the scans.
  double large = 3;
  // With regions that are said to go or stay, the model is looked at only if large triangles are at
  // least this share of its area; where it is refused, if this one. Others lose less than is told.
  double min_large_share = 0.01;
  double min_large_share_if_refused = 0.5;
  // The spacing of scans is the distance of their samples from the neighbor of this rank. With the
  // fourth, about an edge of their surface, walls of real parts came out with handles too many.
  std::size_t neighbor = 1;
  // Made dense only if that takes at most so many samples.
  double most_samples = 5e6;
  // Taken if at most this share of what was lost is lost then.
  double max_lost = 0.5;
};

// Updates the model, and if it is the mesh of a file that loses surface, or cannot be updated,
// since its triangles are too large for the scans, makes it dense (with_dense_model) and updates it
// again. If that keeps more of the surface it becomes the `input`, and a warning says so; else the
// first outcome is returned, and the report is as if there had been no other. Section
// "update/coarse_model" of the report. A model with properties is updated as it is, since samples
// between its vertices have none. What is said of regions holds for the model that is chosen
// without. Stages come again. Throws InputError as `updated`.
UpdateOutcome updated_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                                   const CoarseModelOptions& coarse = {});

}  // namespace cocoon::app
