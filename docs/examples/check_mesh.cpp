// Two tetrahedra that share an edge: what the checker says, and the manifold it can be split into.
#include <cstdio>
#include <string>
#include <vector>

#include "geom/mesh/split_nonmanifold.h"
#include "geom/mesh_check.h"
#include "geom/triangle_mesh.h"

int main() {
  cocoon::TriangleMesh mesh;
  const std::vector<cocoon::Point> points = {{0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                             {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  for (const cocoon::Point& p : points) mesh.points.push_back(p);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({cocoon::VertexId(a), cocoon::VertexId(b), cocoon::VertexId(c)});
  };
  for (const std::uint32_t first : {2U, 4U}) {
    const std::uint32_t second = first + 1;
    add(0, first, 1);
    add(0, 1, second);
    add(0, second, first);
    add(1, first, second);
  }

  // Counts, and the first offenders by name.
  const cocoon::MeshReport before = cocoon::mesh_check(mesh);
  std::printf("closed: %d, edges with more than two triangles: %zu\n", before.watertight ? 1 : 0,
              before.overfull_edges);

  // The surface stays where it is; each body gets ends of the edge of its own.
  const cocoon::SplitSurface split = cocoon::split_nonmanifold(mesh);
  const cocoon::MeshReport after = cocoon::mesh_check(split.mesh);
  std::printf("split: %zu copies of vertices, %zu bodies\n", split.copies, after.components);
  const bool as_expected = before.balanced && before.overfull_edges == 1 && split.copies == 2 &&
                           after.is_closed_manifold() && after.components == 2;
  return as_expected ? 0 : 1;
}
