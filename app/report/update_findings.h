// What is to be said of an update and of its result, in words.
#pragma once

#include <string>
#include <vector>

#include "app/report/findings.h"
#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/mesh_check.h"
#include "geom/point.h"
#include "update/update_model.h"

namespace cocoon::app {

// What is doubtful about the surface of an updated model, `surface` with its mesh, made from
// `points`. Long edges beside short ones are no gaps here: they are at the rim of every cloud that
// is denser than the model. What the stages counted is of the whole model, and nothing that this
// update could be told of. Noise is always a warning: few models have it. `left`: options that the
// command has. `certificate` gets that of the surface. Complexity: as surface_doubts.
std::vector<Finding> findings_of_update(const ReconstructResult& surface, Points points,
                                        NoiseFilter filter, const OptionsLeft& left,
                                        const Execution& execution, MeshReport& certificate);

// What the findings of an update are to say of its filter.
NoiseFilter noise_filter_of_update(bool filtered);

// Of clouds whose samples lie much farther apart in some places than in others (spacing_range); and
// what to try where the surface has handles or parts that nothing explains, and many samples lie
// closer together than the vertices of the model.
std::vector<std::string> notes_of_clouds(const UpdateResult& result,
                                         const std::vector<std::string>& names,
                                         const UpdateOptions& options);

// Messages of the library number the clouds ("cloud 1 of 2"); people know them by their files.
std::string with_cloud_names(const std::string& message, const std::vector<std::string>& names);

}  // namespace cocoon::app
