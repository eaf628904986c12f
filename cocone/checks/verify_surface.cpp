#include "cocone/checks/verify_surface.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "cocone/marking/pass_labels.h"
#include "geom/mesh_check.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

constexpr std::size_t cells_between_reports = std::size_t{1} << 16;

// Corners in increasing order, and whether it took an odd number of swaps to bring them there.
struct SortedTriangle {
  Triangle corners;
  bool odd = false;
};

SortedTriangle sorted_triangle(const Triangle& triangle) {
  const auto [a, b, c] = triangle;
  SortedTriangle sorted{triangle, (a > b) != ((b > c) != (a > c))};
  std::sort(sorted.corners.begin(), sorted.corners.end());
  return sorted;
}

// The triangles of a surface, by their vertices in the triangulation; each is to be found among the
// facets.
class WantedFacets {
 public:
  explicit WantedFacets(const SurfaceMesh& surface) {
    const auto& vertices = surface.triangulation_vertex;
    for (const auto& [a, b, c] : surface.mesh.triangles) {
      wanted_.push_back(sorted_triangle({vertices[a], vertices[b], vertices[c]}));
    }
    std::sort(wanted_.begin(), wanted_.end(),
              [](const auto& a, const auto& b) { return a.corners < b.corners; });
    found_.resize(wanted_.size(), 0);
  }

  // begins_[v]: the first wanted triangle whose smallest vertex is v or a later one.
  void look_for_all(const Triangulation& triangulation, const Execution& execution) {
    begins_.assign(triangulation.num_vertices() + 1, 0);
    for (const SortedTriangle& triangle : wanted_) {
      const std::size_t first = triangle.corners[0].index();
      if (first < triangulation.num_vertices()) ++begins_[first + 1];
    }
    for (std::size_t v = 1; v < begins_.size(); ++v) begins_[v] += begins_[v - 1];
    met_.resize(triangulation.num_cells(), 0);
    const auto cells = static_cast<double>(triangulation.num_finite_cells());
    for (const CellId c : triangulation.finite_cells()) {
      if (c.index() % cells_between_reports == 0) {
        report_progress(execution, "find_facets", static_cast<double>(c.index()) / cells);
      }
      for (int i = 0; i < 4; ++i) note(triangulation, facet_id(c, i));
    }
    report_progress(execution, "find_facets", 1);
  }

  std::size_t missing() const {
    return static_cast<std::size_t>(std::count(found_.begin(), found_.end(), 0));
  }

  // How many of the triangles have their normals point into the body. Precondition: they are found,
  // none is there twice, and every edge has an even number of them.
  std::size_t turned(const Triangulation& triangulation) const {
    const IdVector<CellId, std::uint8_t> inside = body(triangulation);
    std::size_t turned = 0;
    for (const CellId c : triangulation.finite_cells()) {
      if (inside[c] != 0)
        turned += static_cast<std::size_t>(std::popcount(unsigned{met_[c]} >> 4U));
    }
    return turned;
  }

 private:
  // The corners of facet f run counterclockwise seen from behind it.
  void note(const Triangulation& triangulation, FacetId f) {
    const auto [corners, odd] = sorted_triangle(triangulation.facet_vertices(f));
    for (std::size_t k = begins_[corners[0].index()]; k < begins_[corners[0].index() + 1]; ++k) {
      if (wanted_[k].corners != corners) continue;
      found_[k] = 1;
      const unsigned facing_in = wanted_[k].odd != odd ? 1 : 0;
      met_[cell_of(f)] |= static_cast<std::uint8_t>((1U | facing_in << 4U) << index_of(f));
    }
  }

  bool is_met(FacetId f) const { return (met_[cell_of(f)] >> index_of(f) & 1U) != 0; }

  // 1 = an odd number of triangles is crossed on any way from infinity.
  IdVector<CellId, std::uint8_t> body(const Triangulation& triangulation) const {
    constexpr std::uint8_t unknown = 2;
    IdVector<CellId, std::uint8_t> inside(triangulation.num_cells(), unknown);
    for (const CellId c : triangulation.infinite_cells()) inside[c] = 0;
    // In the order of memory: cells that are neighbors lie near each other.
    std::vector<CellId> left(triangulation.num_finite_cells());
    for (std::size_t k = 0; k < left.size(); ++k) left[k] = CellId(k);
    const auto take_label = [&](CellId c) {
      for (int i = 0; i < 4 && inside[c] == unknown; ++i) {
        const std::uint8_t behind = inside[triangulation.neighbor(c, i)];
        if (behind == unknown) continue;
        inside[c] = static_cast<std::uint8_t>(behind ^ (is_met(facet_id(c, i)) ? 1U : 0U));
      }
      return inside[c] != unknown;
    };
    pass_labels(left, take_label);
    return inside;
  }

  std::vector<SortedTriangle> wanted_;
  std::vector<std::uint8_t> found_;
  std::vector<std::size_t> begins_;
  // Of each finite cell: bit i = its facet i is a triangle, bit 4 + i = whose normal points into
  // the cell.
  IdVector<CellId, std::uint8_t> met_;
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
  if (v.turned_triangles > 0) {
    return counted(v.turned_triangles, "triangles of the closed surface face its inside");
  }
  return {};
}

SurfaceVerification verified(const Triangulation& triangulation, const SurfaceMesh& surface,
                             Points points, const VerifyOptions& options,
                             const Execution& execution) {
  SurfaceVerification result;
  result.done = true;
  result.cells = triangulation.num_finite_cells();
  result.triangles = surface.mesh.triangles.size();
  result.delaunay = check_delaunay(triangulation, execution);
  WantedFacets facets(surface);
  // Cells that cannot be read have no facets.
  if (result.delaunay.malformed_cells == 0) {
    facets.look_for_all(triangulation, execution);
    result.strange_triangles = facets.missing();
  }
  result.moved_vertices = count_moved(triangulation, surface, points, options.scale);
  const MeshReport mesh = mesh_check(surface.mesh, {}, execution);
  result.repeated_corners = mesh.repeated_vertex_triangles;
  result.repeated_triangles = mesh.duplicate_triangles;
  if (options.closed) result.unbalanced_edges = mesh.unbalanced_edges;
  result.failure = failure_of(result);
  // Only what is right so far has an inside.
  if (options.closed && result.failure.empty()) {
    result.turned_triangles = facets.turned(triangulation);
    result.failure = failure_of(result);
  }
  return result;
}

}  // namespace

SurfaceVerification verify_surface(const Triangulation& triangulation, const SurfaceMesh& surface,
                                   Points points, const VerifyOptions& options,
                                   const Execution& execution) {
  require_size("verify_surface", "points of the surface's vertices", surface.point_of_vertex.size(),
               surface.mesh.points.size());
  require_size("verify_surface", "vertices of the triangulation",
               surface.triangulation_vertex.size(), surface.mesh.points.size());
  return run_step(execution, "verify", [&](const Execution& nested) {
    return verified(triangulation, surface, points, options, nested);
  });
}

}  // namespace cocoon
