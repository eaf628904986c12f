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
void add_reconstruction(Job& job, const ReconstructResult& result, const MeshReport& certificate);

// The section "noise": what was left out before the reconstruction.
void add_noise(JsonReport& report, const NoiseCounters& noise);

// What the user may try where there is no surface: no advice names an option that the command does
// not have, or that is not of this surface.
struct SurfaceRemedies {
  bool noise_filter = false;  // --noise robust
  bool rho = true;            // --rho
  std::string other = {};     // anything else, after a comma
};

// Of the model of an update: the command's own options are of its clouds.
SurfaceRemedies remedies_of_model();

// Throws InputError unless the status is ok: what failed, the numbers and places that say why, what
// to try; `points` and `options` are those of the reconstruction. If a verification was asked for,
// it goes to the report (app/report/verification.h), or refutes the result.
void require_surface(Job& job, const std::string& file, const ReconstructResult& result,
                     Points points, const ReconstructOptions& options,
                     const SurfaceRemedies& remedies = {});

}  // namespace cocoon::app
