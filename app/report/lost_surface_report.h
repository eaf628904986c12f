// What an update has lost or made up, for people and for the JSON report.
#pragma once

#include <string>

#include "app/json_report.h"
#include "geom/triangle_mesh.h"
#include "update/checks/lost_surface.h"

namespace cocoon::app {

// Its counts, to the section "update".
void add_lost_surface(JsonReport& report, const LostSurface& lost);

// What the user is told, and what to do. `tried`: what became of a trial to make the model dense
// that was not taken; empty: there was none. Precondition: lost.warns.
std::string warning_of_lost_surface(const LostSurface& lost, const std::string& tried,
                                    const std::string& model_name, const TriangleMesh& model);

// Likewise. Precondition: lost.makes_up.
std::string warning_of_made_up_surface(const LostSurface& lost, const std::string& model_name);

}  // namespace cocoon::app
