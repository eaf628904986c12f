// The surface of an update: of all samples, or without those that crowd.
#pragma once

#include <optional>
#include <span>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/model/irregular_sides.h"
#include "update/replaced_vertices.h"
#include "update/steps/update_run.h"
#include "update/update_model.h"

namespace cocoon {

// Has these vertices go and samples come, and reconstructs. Where the surface has handles that
// nothing explains, or loose parts, many samples crowd in layers (CrowdedOptions), and some of its
// own handles or parts are no wider than layers make them, it is made again without these samples,
// and taken, with a warning, if it has fewer such handles and parts, and hardly less of anything
// else. Enters in the result what the points and the surface are, its handles and loose parts, the
// Euler numbers of it and of the model, and what crowds. `irregular`: irregular_sides() of the
// model. Returns the triangles of the surface that have a sample among their corners, and others,
// perhaps (they live as long as the result's mesh, or as UpdatedSurface::changed); or none, with
// the status, if there is no surface, or if it was refuted. Errors and complexity: those of
// replace_points() and of parts.reconstruct, which is called up to three times. Source: Woo & Dey
// 2005, section 3.5; docs/departures.md, departure 25.
std::optional<std::span<const Triangle>> make_surface(UpdateRun& run, const UpdateParts& parts,
                                                      const ReplacedVertices& replaced,
                                                      std::span<const EdgeSide> irregular,
                                                      const Execution& execution);

// The vertices of the surface that it entered: of the mesh, or if that was left out all points.
Points vertices_of_surface(const UpdateResult& result);

}  // namespace cocoon
