#include "app/report/lost_surface.h"

#include <algorithm>
#include <fmt/format.h>

#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"
#include "update/report/cloud_report.h"

namespace cocoon::app {

LostSurface lost_surface(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds,
                         const SessionUpdate& update, const TriangleMesh& updated) {
  const UpdateResult& result = update.result;
  const AstrayOptions options;
  LostSurface lost;
  lost.triangles =
      lost_triangles(model, result.replacement.point_of_vertex, update.change.triangle_map);
  const LostTriangles& found = lost.triangles;
  const double least = options.min_lost_share * static_cast<double>(found.staying);
  if (found.lost.empty() || static_cast<double>(found.lost.size()) < least) return lost;
  const std::vector<Scan> scans = scans_of(clouds, result.clouds);
  double spacing = 0;
  for (const Scan& scan : scans) spacing = std::max(spacing, scan.spacing);
  lost.astray = astray_triangles(model, found.lost, updated, scans, options);
  lost.share = lost.astray.area / found.staying_area;
  lost.warns = *lost.share > options.min_area_share;
  lost.is_coarse = *lost.share > options.min_coarse_share &&
                   lost.astray.median_longest_edge > options.coarse_ratio * spacing;
  return lost;
}

void add_lost_surface(JsonReport& report, const LostSurface& lost) {
  report.set("update/staying_triangles", lost.triangles.staying);
  report.set("update/lost_triangles", lost.triangles.lost.size());
  if (lost.share) report.set("update/astray_area_share", *lost.share);
}

std::string warning_of_lost_surface(const LostSurface& lost, const std::string& model_name,
                                    const TriangleMesh& model) {
  const std::string warning =
      fmt::format("{:.0f} % of the surface of {} is not kept though nothing was scanned there",
                  100 * *lost.share, model_name);
  if (lost.tried) {
    return warning + fmt::format(
                         ": it has too few vertices, and made dense (--densify {}) it "
                         "keeps no more; look at the result",
                         *lost.tried);
  }
  if (lost.is_coarse) {
    return warning +
           ": it has too few vertices; make it dense first (--densify SPACING, about that of the "
           "scans)";
  }
  const Triangle& corners = model.triangles[lost.astray.largest];
  return warning + fmt::format(" ({}, as at {}); look at the result",
                               counted(lost.astray.count, "triangle"),
                               place_name(model.points[corners[0]]));
}

}  // namespace cocoon::app
