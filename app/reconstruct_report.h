// What a reconstruction found, as reports and error messages say it.
#pragma once

#include <string>

#include "app/job.h"
#include "app/json_report.h"
#include "cocone/reconstruct.h"
#include "cocone/robust_cocone.h"
#include "geom/mesh_check.h"

namespace cocoon::app {

// The sections "input", "delaunay", "surface" and "counters" of the JSON report.
void add_reconstruction(JsonReport& report, const ReconstructResult& result,
                        const MeshReport& certificate);

// The section "noise": what was left out before the reconstruction.
void add_noise(JsonReport& report, const NoiseCounters& noise);

// Throws InputError unless the status is ok: what failed, the numbers and places that say why, what
// to try; `points` and `options` are those of the reconstruction. If a verification was asked for,
// it goes to the report (app/verification.h), or refutes the result. `other_remedy`: what else to
// try, after a comma.
void require_surface(Job& job, const std::string& file, const ReconstructResult& result,
                     Points points, const ReconstructOptions& options,
                     const std::string& other_remedy = {});

}  // namespace cocoon::app
