#include "geom/mesh/triangles_at_vertices.h"

#include <cstddef>

#include "geom/arrays/large_pages.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/execution.h"

namespace cocoon {

TrianglesAtVertices triangles_at_vertices(const TriangleMesh& mesh, const Execution& execution) {
  TrianglesAtVertices result;
  std::vector<TriangleId>& listed = result.triangles;
  result.begins = sort_by_vertex(
      mesh.triangles.size(), mesh.points.size(), execution,
      [&](std::size_t count) {
        listed.reserve(count);
        prefer_large_pages(listed);
        listed.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (TriangleId t(begin); t.index() < end; ++t) {
          const auto write = [&](std::uint32_t place) { listed[place] = t; };
          const Triangle& corners = mesh.triangles[t];  // equal ones count once
          put(corners[0], write);
          if (corners[1] != corners[0]) put(corners[1], write);
          if (corners[2] != corners[0] && corners[2] != corners[1]) put(corners[2], write);
        }
      });
  return result;
}

}  // namespace cocoon
