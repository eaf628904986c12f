// Where the rims of all clouds lie on the model, and which trial has found the rim of each.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "update/cloud_surface.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"
#include "update/report/cloud_report.h"

namespace cocoon {

struct UpdateOptions;

struct LocatedRims {
  std::vector<Overlap> overlaps;                      // of each cloud
  std::vector<std::vector<std::size_t>> shared_with;  // of each cloud, by mark_shared_edges()
};

// What is known of a cloud once it has this surface.
CloudReport report_of_surface(CloudSurface surface);

// Opens pin-holes through which the model goes on, marks edges that are shared or seams, and looks
// for the overlapping facets of each rim; `reports` have the rims, and get what is found. Where
// the rim of a cloud is not on the model, the best of its other surfaces that has one there is
// taken. Where it is, but leaves a doubt (rim_doubt.h) and is shared with no other cloud, the rims
// of the others are looked at, and the clearest is taken if it is far clearer (CutOptions), unless
// what goes by it, and not by the first one, reaches far from the samples. A rim that is not on the
// model after all that may be so by take_shadowed_rim(), or that of another surface. The number of
// rims that were compared is in the report. others[c]: surfaces of clouds[c], the ones to be
// preferred first. Errors: InputError unless there are as many reports and others as clouds, and as
// the stages. Complexity: that of overlapping_facets() for each rim, and of rim_doubt() for those
// that are compared. Source: ours; Woo & Dey 2005, section 3.3 presumes one rim, on the model.
LocatedRims locate_rims(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                        std::span<const std::vector<CloudSurface>> others,
                        const UpdateOptions& options, std::span<CloudReport> reports,
                        const Execution& execution = {});

}  // namespace cocoon
