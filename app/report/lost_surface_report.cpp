#include "app/report/lost_surface_report.h"

#include <fmt/format.h>

#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"

namespace cocoon::app {

void add_lost_surface(JsonReport& report, const LostSurface& lost) {
  report.set("update/staying_triangles", lost.triangles.staying);
  report.set("update/lost_triangles", lost.triangles.lost.size());
  if (lost.share) report.set("update/astray_area_share", *lost.share);
  report.set("update/made_up_places", lost.made_up.places);
  if (lost.made_up.places > 0) report.set("update/made_up_distance", lost.made_up.distance);
}

std::string warning_of_lost_surface(const LostSurface& lost, const std::string& tried,
                                    const std::string& model_name, const TriangleMesh& model) {
  const std::string warning =
      fmt::format("{:.0f} % of the surface of {} is not kept though nothing was scanned there",
                  100 * *lost.share, model_name);
  if (!tried.empty()) {
    return warning + ": its triangles are large, and " + tried + "; look at the result";
  }
  if (lost.is_coarse) {
    return warning +
           ": its triangles are too large; make it dense first (--densify SPACING, about that of "
           "the scans)";
  }
  const Triangle& corners = model.triangles[lost.astray.largest];
  return warning + fmt::format(" ({}, as at {}); look at the result",
                               counted(lost.astray.count, "triangle"),
                               place_name(model.points[corners[0]]));
}

std::string warning_of_made_up_surface(const LostSurface& lost, const std::string& model_name) {
  const MadeUpSurface& made_up = lost.made_up;
  return fmt::format(
      "the new surface joins vertices of {} where nothing was scanned, up to {:.3g} ({:.1f} times "
      "the spacing) off its surface, as at {}; look at the result",
      model_name, made_up.distance, made_up.distance / lost.spacing, place_name(made_up.farthest));
}

}  // namespace cocoon::app
