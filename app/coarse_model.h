// Models whose triangles are too large for their scans, as CAD programs give them: an update makes
// the new mesh from points alone, and from few vertices it makes another shape.
#pragma once

#include <string>

#include "app/job.h"
#include "app/update_input.h"
#include "app/updating.h"
#include "update/update_model.h"

namespace cocoon::app {

struct CoarseModelOptions {
  // By make_dense_enough the model is looked at only if triangles that are too large (large_side)
  // are at least this share of its area; where an update is refused, if this one. Others lose less
  // than is told.
  double min_large_share = 0.01;
  double min_large_share_if_refused = 0.5;
  // The spacing of a scan is this part of the distance of its samples from the neighbor of this
  // rank. With the nearest, views that overlap in one file would seem much denser than they are.
  std::size_t neighbor = 8;
  double neighbor_share = 0.5;
  // Samples are as far apart as those of the scans, but no more than about so many: 20 s of work.
  double most_samples = 5e5;
  // How much has to be lost, so that it is worth the time, and at most.
  LostSurfaceOptions lost = {};
  // Taken if what it alone loses or makes up is at most this part of what the first alone does.
  double max_given_up = 0.5;
};

// Whether an update takes its model as it is: if it was told to, and in paper mode, as published.
template <class Arguments>
bool keeps_coarse(const Arguments& arguments) {
  return arguments.keep_coarse || arguments.parameters.mode == Mode::paper;
}

// Updates the model, and if it is the mesh of a file that loses surface, or cannot be updated,
// since its triangles are too large for the scans, makes it dense (with_dense_model) and updates it
// again. If that keeps more of the surface where nothing was scanned, it becomes the `input`, and a
// warning says so; else the first outcome is returned, and nothing is told of the other but why.
// Section "update/coarse_model" of the report. What is said of regions holds for the model that is
// chosen without. Stages come again. Throws InputError as `updated`.
UpdateOutcome updated_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                                   const CoarseModelOptions& coarse = {});

// For an update that is yet to come, of a session or with regions that are said to go or stay:
// makes the model dense if updated_dense_enough would, and tells the user the same; not if few of
// its triangles are large (min_large_share), which is known without an update. Returns what became
// of a trial that was not taken (LostSurface::tried). Throws as `updated`.
std::string make_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                              const CoarseModelOptions& coarse = {});

}  // namespace cocoon::app
