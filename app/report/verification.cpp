#include "app/report/verification.h"

#include <fmt/format.h>

#include "geom/errors.h"

namespace cocoon::app {

namespace {

void require_verified(const std::string& file, const std::string& failure) {
  if (failure.empty()) return;
  throw Error(
      fmt::format("{}: the result failed its verification and is not written: {}; this is "
                  "a fault of the program or the machine, please report it",
                  file, failure));
}

}  // namespace

void report_verification(JsonReport& report, const std::string& file,
                         const SurfaceVerification& verification) {
  if (!verification.done) return;
  require_verified(file, verification.failure);
  report.set("verification/ok", true);
  report.set("verification/tetrahedra", verification.cells);
  report.set("verification/triangles", verification.triangles);
}

void report_verification(JsonReport& report, const std::string& file, std::size_t cells,
                         const DelaunayReport& delaunay) {
  require_verified(file, delaunay.first_violation);
  report.set("verification/ok", true);
  report.set("verification/tetrahedra", cells);
}

}  // namespace cocoon::app
