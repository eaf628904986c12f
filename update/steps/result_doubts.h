// What may be wrong with an updated model, asked when it is there.
#pragma once

#include <span>
#include <vector>

#include "cocone/boundary_loops.h"
#include "geom/point.h"
#include "geom/search/nearest_point.h"
#include "update/cloud_rim.h"
#include "update/joined_clouds.h"
#include "update/model/irregular_sides.h"
#include "update/model/model_index.h"
#include "update/update_model.h"

namespace cocoon {

// The clouds of an update, those that overlap taken as one.
struct UpdatedClouds {
  std::span<const std::vector<Point>> given;
  std::span<const JoinedCloud> joined;          // of `given`, each in one of them
  std::span<const std::vector<Point>> samples;  // of each joined cloud
  std::span<const CloudRim> rims;               // of these, on the border (border_rims_of)
  std::span<const NearestPointTree> trees;      // of the samples
};

// Warns of vertices of the model amid new samples, of parts that hang together with nothing of the
// model, and of handles that nothing explains; looks for samples that contradict each other,
// changes that are not on the surface, gaps that it bridges, openings that are closed, and vertices
// that went though nothing was scanned near them. Enters what is found, and a warning for each that
// is doubtful. `model`: the one that was updated; `irregular`: irregular_sides() of it;
// `triangles`: those that make_surface() returned. Precondition: the result has all that
// make_surface() enters, and its clouds are the joined ones. Complexity: that of the functions in
// `update/checks/` that it asks.
void enter_doubts(const ModelIndex& model, std::span<const EdgeSide> irregular,
                  const UpdatedClouds& clouds, std::span<const Triangle> triangles,
                  const UpdateOptions& options, UpdateResult& result);

}  // namespace cocoon
