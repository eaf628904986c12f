#include "cocone/orient_surface.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "cocone/facets/facet_size.h"
#include "geom/messages/require_size.h"

namespace cocoon {
namespace {

FacetSize size_of(const TriangleMesh& mesh, TriangleId t) {
  return size_of_triangle(sorted_corners(corners_of(mesh, t)));
}

// Whether the triangles of a component that run against its first one stay and the others turn: if
// they are more, or as many and the smallest triangle is among them.
std::vector<std::uint8_t> choose_ways(const TriangleMesh& mesh, const EdgeComponents& found) {
  const std::vector<EdgeComponent>& components = found.components;
  std::vector<std::uint8_t> ways(components.size(), 0);
  bool has_tie = false;
  for (std::size_t k = 0; k < components.size(); ++k) {
    ways[k] = 2 * components[k].turned > components[k].triangles ? 1 : 0;
    has_tie |= 2 * components[k].turned == components[k].triangles;
  }
  if (!has_tie) return ways;
  std::vector<TriangleId> smallest(components.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    const std::uint32_t k = found.component_of[t.index()];
    if (2 * components[k].turned != components[k].triangles) continue;
    if (smallest[k].is_none() || size_of(mesh, t) < size_of(mesh, smallest[k])) {
      smallest[k] = t;
      ways[k] = found.turned[t.index()];
    }
  }
  return ways;
}

}  // namespace

OrientationReport orient_surface(TriangleMesh& mesh) {
  return orient_surface(mesh, edge_components(mesh, link_halfedges(mesh)));
}

OrientationReport orient_surface(TriangleMesh& mesh, const EdgeComponents& found) {
  require_size("orient_surface", "triangles in components", found.component_of.size(),
               mesh.triangles.size());
  OrientationReport report;
  bool any_turned = false;
  for (const EdgeComponent& component : found.components) {
    report.non_orientable += component.is_contradictory ? 1U : 0U;
    any_turned |= component.turned > 0;
  }
  if (!any_turned) return report;
  const std::vector<std::uint8_t> ways = choose_ways(mesh, found);
  for (const TriangleId t : mesh.triangles.ids()) {
    const std::uint32_t k = found.component_of[t.index()];
    if (found.components[k].is_contradictory || found.turned[t.index()] == ways[k]) continue;
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    ++report.flipped;
  }
  return report;
}

}  // namespace cocoon
