#include "update/checks/lost_surface.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/mesh/triangles_by_area.h"
#include "update/checks/model_places.h"
#include "update/model/updated_vertices.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Whether the update says that the triangle is to go: one of a replaced region, not of its border.
bool is_replaced(const UpdateResult& result, TriangleId t) {
  if (result.replaced_groups.empty()) return false;
  const RegionId region = result.regions.region_of_facet[t];
  const auto& groups = result.replaced_groups;
  return std::find(groups.begin(), groups.end(), region) != groups.end();
}

std::vector<TriangleId> large_lost(const TriangleMesh& model, const UpdateResult& result,
                                   const MeshChange& change, double large) {
  std::vector<TriangleId> lost;
  for (const TriangleId t : model.triangles.ids()) {
    const bool has_gone = change.triangle_map[t].is_none();
    if (has_gone && longest_edge(model, t) > large && !is_replaced(result, t)) {
      lost.push_back(t);
    }
  }
  return lost;
}

// The triangles of the updated mesh that the model has not.
std::vector<TriangleId> new_triangles(const TriangleMesh& updated, const MeshChange& change) {
  IdVector<TriangleId, std::uint8_t> was_there(updated.triangles.size(), 0);
  for (const TriangleId t : change.triangle_map) {
    if (!t.is_none()) was_there[t] = 1;
  }
  std::vector<TriangleId> added;
  for (const TriangleId t : updated.triangles.ids()) {
    if (was_there[t] == 0) added.push_back(t);
  }
  return added;
}

std::vector<TriangleId> large_among(std::span<const TriangleId> triangles, const TriangleMesh& mesh,
                                    double large) {
  std::vector<TriangleId> found;
  for (const TriangleId t : triangles) {
    if (longest_edge(mesh, t) > large) found.push_back(t);
  }
  return found;
}

// Those without a vertex of a cloud.
std::vector<TriangleId> between_old_vertices(std::span<const TriangleId> triangles,
                                             const TriangleMesh& mesh, VertexId first_of_clouds) {
  std::vector<TriangleId> found;
  for (const TriangleId t : triangles) {
    const Triangle& corners = mesh.triangles[t];
    const bool all_old = std::all_of(corners.begin(), corners.end(),
                                     [&](VertexId v) { return v < first_of_clouds; });
    if (all_old) found.push_back(t);
  }
  return found;
}

// large_share, made_up and makes_up. Of most models no triangle is large, and none is new away from
// the scans.
void look_where_nothing_was_scanned(const TriangleMesh& model, const TriangleMesh& updated,
                                    const UpdateResult& result, const MeshChange& change,
                                    std::span<const Scan> scans, const AstrayOptions& options,
                                    LostSurface& lost) {
  const std::vector<TriangleId> added = new_triangles(updated, change);
  const double large = large_side(scans, options);
  const std::vector<TriangleId> large_gone = large_lost(model, result, change, large);
  const bool closes_openings = result.closed_openings.edges > 0;
  const std::vector<TriangleId> large_added =
      closes_openings ? std::vector<TriangleId>{} : large_among(added, updated, large);
  const std::vector<TriangleId> between =
      between_old_vertices(added, updated, first_vertex_of_clouds(change.vertex_map));
  if (large_gone.empty() && large_added.empty() && between.empty()) return;
  const UnscannedPlaces places(scans, options);
  const double area = places.area_off(places.of(model, large_gone), updated) +
                      places.area_off(places.of(updated, large_added), model);
  if (area > 0) lost.large_share = area / TrianglesByArea(model).area();
  lost.made_up = made_up_surface(model, updated, between, places);
  lost.spacing = places.spacing();
  lost.makes_up = lost.made_up.places > 0 && !closes_openings;
}

}  // namespace

LostSurface lost_surface(const TriangleMesh& model, std::span<const Scan> scans,
                         const UpdateResult& result, const MeshChange& change,
                         const TriangleMesh& updated, const LostSurfaceOptions& options) {
  require_options("lost_surface", options);
  LostSurface lost;
  lost.triangles = lost_triangles(model, result.replacement.point_of_vertex, change.triangle_map);
  const LostTriangles& found = lost.triangles;
  look_where_nothing_was_scanned(model, updated, result, change, scans, options.astray, lost);
  if (!(found.lost_area > options.min_coarse_share * found.staying_area)) return lost;
  lost.astray = astray_triangles(model, found.lost, updated, scans, options.astray);
  lost.share = lost.astray.area / found.staying_area;
  lost.warns = *lost.share > options.min_area_share;
  lost.is_coarse =
      lost.astray.median_longest_edge > options.astray.coarse_ratio * largest_spacing(scans);
  return lost;
}

}  // namespace cocoon
