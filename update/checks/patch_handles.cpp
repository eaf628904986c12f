#include "update/checks/patch_handles.h"

#include <algorithm>
#include <vector>

#include "cocone/boundary_loops.h"
#include "geom/arrays/sort_ids.h"
#include "geom/box.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/mesh/narrow_handles.h"
#include "geom/mesh/split_nonmanifold.h"
#include "geom/mesh_check.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

// With their vertices numbered in the order in which they were.
TriangleMesh patch_of(Points vertices, std::span<const Triangle> triangles, VertexId first_new) {
  TriangleMesh patch;
  std::vector<VertexId> corners;
  for (const Triangle& t : triangles) {
    if (std::none_of(t.begin(), t.end(), [&](VertexId v) { return v >= first_new; })) continue;
    patch.triangles.push_back(t);
    corners.insert(corners.end(), t.begin(), t.end());
  }
  make_set(corners);
  if (!corners.empty()) {
    require_index("patch_handles", "vertex", corners.back().index(), vertices.size());
  }
  for (const VertexId v : corners) patch.points.push_back(vertices[v.index()]);
  for (Triangle& t : patch.triangles) {
    for (VertexId& v : t) {
      v = VertexId(static_cast<std::size_t>(std::lower_bound(corners.begin(), corners.end(), v) -
                                            corners.begin()));
    }
  }
  return patch;
}

// Puts a cone over each boundary loop, with its top so far away that no short path leads over it.
void close_openings(TriangleMesh& mesh) {
  const BoundaryLoops openings = boundary_loops(mesh, {.min_component_share = 0});
  const Box box = box_of(mesh.points.span());
  Point top = box.high + 10 * box.size();
  for (const BoundaryLoop& opening : openings.loops) {
    const VertexId apex = mesh.points.push_back(top);
    top = top + box.size();
    for (const BoundaryEdge& edge : opening.edges) {
      mesh.triangles.push_back({edge.to, edge.from, apex});
    }
  }
}

}  // namespace

std::vector<double> patch_handles(Points vertices, std::span<const Triangle> triangles,
                                  VertexId first_new) {
  TriangleMesh patch = split_nonmanifold(patch_of(vertices, triangles, first_new)).mesh;
  close_openings(patch);
  const LinkedMesh linked = link_mesh(patch);
  const std::size_t handles = mesh_check(linked).genus.value_or(0);
  std::vector<double> lengths;
  for (const NarrowHandle& handle : narrow_handles(linked, handles)) {
    lengths.push_back(handle.length);
  }
  return lengths;
}

}  // namespace cocoon
