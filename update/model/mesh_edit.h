// An update of a mesh as a list of what went and came, told by those who know where to look.
#pragma once

#include <span>
#include <vector>

#include "geom/arrays/list_edit.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/model/model_index.h"

namespace cocoon {

// Between two meshes in canonical order. All other vertices and triangles stay in their order.
struct MeshEdit {
  ListEdit<VertexId> vertices;
  std::vector<Point> removed_points;
  std::vector<Point> added_points;
  ListEdit<TriangleId> triangles;
  std::vector<Triangle> removed;  // by vertices before
  std::vector<Triangle> added;    // by vertices after

  MeshEdit reversed() const;
};

// The edit of the index' mesh at some of its vertices (ascending): `triangles` are all that these
// and new vertices have in the end, by vertices after, in canonical order; elsewhere nothing
// changes. New vertices come last. `vertex_map`: places_after(vertices). Precondition: a mesh in
// canonical order, each triangle once. Complexity: O(k log n) for k triangles at these vertices.
MeshEdit mesh_edit(const ModelIndex& before, ListEdit<VertexId> vertices,
                   const IdVector<VertexId, VertexId>& vertex_map,
                   std::span<const Point> added_points, std::span<const VertexId> touched,
                   std::span<const Triangle> triangles);

// Whether an edit that was carried out leads to what an edit with these `touched` and `triangles`
// leads to; `after`: the index of the mesh now. New vertices may lie anywhere. Complexity: O(k log
// k) for k triangles that changed or are at these vertices.
bool leads_to(const MeshEdit& edit, const ModelIndex& after,
              const IdVector<VertexId, VertexId>& vertex_map, std::span<const VertexId> touched,
              std::span<const Triangle> triangles);

// Carries the edit out on the triangles. `vertex_map`: places_after(edit.vertices). Complexity:
// O(t), a pass in place.
void edit_triangles(IdVector<TriangleId, Triangle>& triangles, const MeshEdit& edit,
                    const IdVector<VertexId, VertexId>& vertex_map);

}  // namespace cocoon
