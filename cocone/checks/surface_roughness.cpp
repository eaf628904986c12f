#include "cocone/checks/surface_roughness.h"

#include "geom/mesh/edge_components.h"
#include "geom/mesh/halfedges.h"

namespace cocoon {

SurfaceRoughness surface_roughness(const TriangleMesh& surface, std::size_t vertices,
                                   const Execution& execution) {
  const std::size_t parts =
      edge_components(surface, link_halfedges(surface, execution), execution).components.size();
  const auto euler = static_cast<std::ptrdiff_t>(surface.points.size()) -
                     static_cast<std::ptrdiff_t>(surface.triangles.size() / 2);
  return {parts, 2 * static_cast<std::ptrdiff_t>(parts) - euler, vertices - surface.points.size()};
}

}  // namespace cocoon
