#include "geom/linked_sides.h"

#include "geom/mesh_adjacency.h"

namespace cocoon {
namespace {

// Takes the side out of its ring.
void unlink(SideId side, SideLinks& links) {
  SideId before = side;
  while (links[before] != side) before = links[before];
  links[before] = links[side];
  links[side] = LinkedSides::no_side;
}

}  // namespace

LinkedSides link_sides(const TriangleMesh& mesh) {
  require_valid_triangles(mesh);
  LinkedSides sides{side_links(mesh.triangles.span(), mesh.points.size())};
  for (const TriangleId t : mesh.triangles.ids()) {
    if (!repeats_a_vertex(mesh.triangles[t])) continue;
    for (SideId side = 3 * t.value; side < 3 * t.value + 3; ++side) unlink(side, sides.links);
  }
  return sides;
}

LinkedSides link_rest(const LinkedSides& sides, std::span<const std::uint8_t> removed) {
  std::vector<std::uint32_t> number(removed.size());  // of the triangles that are left
  std::uint32_t count = 0;
  for (std::size_t t = 0; t < removed.size(); ++t) {
    number[t] = count;
    count += removed[t] == 0 ? 1U : 0U;
  }
  LinkedSides rest;
  rest.links.reserve(3 * std::size_t{count});
  for (SideId side = 0; side < sides.links.size(); ++side) {
    if (removed[triangle_of_side(side)] != 0) continue;
    SideId next = sides.links[side];
    if (next != LinkedSides::no_side) {
      while (removed[triangle_of_side(next)] != 0) next = sides.links[next];
      next = 3 * number[triangle_of_side(next)] + corner_of_side(next);
    }
    rest.links.push_back(next);
  }
  return rest;
}

}  // namespace cocoon
