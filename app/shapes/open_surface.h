// --trim: a surface without the triangles that span what was not scanned.
#pragma once

#include <cstddef>
#include <string>

#include "app/job.h"
#include "cocone/reconstruct.h"

namespace cocoon::app {

// Takes triangles with an edge longer than so many local spacings out of a surface, at its rim and
// where they hang together (trim_long_edges), and vertices that are then in none. Told in the
// summary and in section "trim" of the report. Throws InputError if no triangle is left.
// `input`: the file of its points. Returns how many vertices went.
std::size_t open_surface(Job& job, const std::string& input, double max_edge,
                         ReconstructResult& surface);

}  // namespace cocoon::app
