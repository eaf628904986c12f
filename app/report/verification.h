// What --verify found: in the report, and as the reason to write nothing.
#pragma once

#include <string>

#include "app/json_report.h"
#include "cocone/checks/verify_surface.h"
#include "delaunay/check_delaunay.h"

namespace cocoon::app {

// The section "verification": what was verified, and that it held. Throws Error, naming `file` and
// what failed, if it did not. Without a verification nothing happens.
void report_verification(JsonReport& report, const std::string& file,
                         const SurfaceVerification& verification);

// The same for a triangulation alone.
void report_verification(JsonReport& report, const std::string& file, std::size_t cells,
                         const DelaunayReport& delaunay);

}  // namespace cocoon::app
