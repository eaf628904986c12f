#include "cocone/checks/verify_surface.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

using Corners = std::array<VertexId, 3>;  // increasing

Corners sorted_corners(const Triangulation& triangulation, FacetId facet) {
  Corners corners = triangulation.facet_vertices(facet);
  std::sort(corners.begin(), corners.end());
  return corners;
}

// The triangles of a surface, by their vertices in the triangulation; each is to be found among the
// facets.
class WantedFacets {
 public:
  explicit WantedFacets(const SurfaceMesh& surface) {
    for (const Triangle& t : surface.mesh.triangles) {
      Corners corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = surface.triangulation_vertex[t[i]];
      std::sort(corners.begin(), corners.end());
      wanted_.push_back(corners);
    }
    std::sort(wanted_.begin(), wanted_.end());
    found_.resize(wanted_.size(), 0);
  }

  // begins_[v]: the first wanted triangle whose smallest vertex is v or a later one.
  void look_for_all(const Triangulation& triangulation) {
    begins_.assign(triangulation.num_vertices() + 1, 0);
    for (const Corners& corners : wanted_) {
      if (corners[0].index() < triangulation.num_vertices()) ++begins_[corners[0].index() + 1];
    }
    for (std::size_t v = 1; v < begins_.size(); ++v) begins_[v] += begins_[v - 1];
    for (const CellId c : triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) note(sorted_corners(triangulation, facet_id(c, i)));
    }
  }

  std::size_t missing() const {
    return static_cast<std::size_t>(std::count(found_.begin(), found_.end(), 0));
  }

 private:
  void note(const Corners& corners) {
    for (std::size_t k = begins_[corners[0].index()]; k < begins_[corners[0].index() + 1]; ++k) {
      if (wanted_[k] == corners) found_[k] = 1;
    }
  }

  std::vector<Corners> wanted_;
  std::vector<std::uint8_t> found_;
  std::vector<std::size_t> begins_;
};

bool same_bits(const Point& a, const Point& b) {
  using Bits = std::array<std::uint64_t, 3>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

std::size_t count_moved(const Triangulation& triangulation, const SurfaceMesh& surface,
                        Points points, double scale) {
  std::size_t moved = 0;
  for (const VertexId v : surface.mesh.points.ids()) {
    const Point& given = points[surface.point_of_vertex[v].index()];
    const Point& triangulated = triangulation.point(surface.triangulation_vertex[v]);
    const bool stays = same_bits(surface.mesh.points[v], given) && scale * given == triangulated;
    moved += stays ? 0U : 1U;
  }
  return moved;
}

std::string failure_of(const SurfaceVerification& v) {
  const auto counted = [](std::size_t count, const char* what) {
    return std::to_string(count) + " " + what;
  };
  if (!v.delaunay.ok()) return "the triangulation is not Delaunay: " + v.delaunay.first_violation;
  if (v.repeated_corners > 0) {
    return counted(v.repeated_corners, "triangles of the surface name a vertex twice");
  }
  if (v.strange_triangles > 0) {
    return counted(v.strange_triangles, "triangles of the surface are no facets of its cells");
  }
  if (v.repeated_triangles > 0) {
    return counted(v.repeated_triangles, "triangles of the surface are there twice");
  }
  if (v.moved_vertices > 0) {
    return counted(v.moved_vertices, "vertices of the surface are not where their points are");
  }
  if (v.unbalanced_edges > 0) {
    return counted(v.unbalanced_edges, "edges of the closed surface are not balanced");
  }
  return {};
}

}  // namespace

SurfaceVerification verify_surface(const Triangulation& triangulation, const SurfaceMesh& surface,
                                   Points points, const VerifyOptions& options,
                                   const Execution& execution) {
  require_size("verify_surface", "points of the surface's vertices", surface.point_of_vertex.size(),
               surface.mesh.points.size());
  require_size("verify_surface", "vertices of the triangulation",
               surface.triangulation_vertex.size(), surface.mesh.points.size());
  report_progress(execution, "verify", 0);
  SurfaceVerification result;
  result.done = true;
  result.cells = triangulation.num_finite_cells();
  result.triangles = surface.mesh.triangles.size();
  result.delaunay = check_delaunay(triangulation, {}, {execution.threads, nullptr});
  report_progress(execution, "verify", 0.7);

  // Cells that cannot be read have no facets.
  if (result.delaunay.malformed_cells == 0) {
    WantedFacets facets(surface);
    facets.look_for_all(triangulation);
    result.strange_triangles = facets.missing();
  }
  result.moved_vertices = count_moved(triangulation, surface, points, options.scale);
  const MeshReport mesh = mesh_check(surface.mesh, {}, {execution.threads, nullptr});
  result.repeated_corners = mesh.repeated_vertex_triangles;
  result.repeated_triangles = mesh.duplicate_triangles;
  if (options.closed) result.unbalanced_edges = mesh.unbalanced_edges;
  result.failure = failure_of(result);
  report_progress(execution, "verify", 1);
  return result;
}

}  // namespace cocoon
