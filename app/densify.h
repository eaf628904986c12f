// --densify: a mesh as a dense sampling of its surface.
#pragma once

#include <string>
#include <vector>

#include "app/job.h"
#include "geom/point.h"

namespace cocoon::app {

// Reads a mesh, as stage "read": its vertices, then samples between them about `spacing` apart, as
// stage "dense_samples"; their number goes to the report and the summary. Throws InputError if the
// file has no triangles, or if the spacing is too small for it.
std::vector<Point> read_densified(Job& job, const std::string& path, double spacing);

}  // namespace cocoon::app
