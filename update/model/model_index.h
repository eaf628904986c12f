// A mesh with what the stages of the update ask of its facets: neighbors, normals, parts. They use
// this; others see geom/mesh/triangle_neighbors.h.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geom/arrays/list_edit.h"
#include "geom/arrays/visit_where.h"
#include "geom/box.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/mesh/triangle_neighbors.h"
#include "geom/mesh/triangles_at_vertices.h"
#include "geom/search/grid_cells.h"
#include "geom/triangle_mesh.h"
#include "update/model/mesh_change.h"

namespace cocoon {

class ModelIndex;

// The index of a mesh before a change, that mesh, and what changed.
struct IndexBefore {
  const ModelIndex& index;
  const TriangleMesh& mesh;
  const MeshChange& change;
  // Whether it is known that no two points of the changed mesh are equal.
  bool distinct_points = false;
};

// Refers to a mesh, which must outlive it and not change. Safe to query from many threads.
class ModelIndex {
 public:
  // Throws InputError for a mesh without triangles, or with a triangle that names a vertex that is
  // not there or has a coordinate that is not finite. Complexity: O(t + v), in part parallel.
  explicit ModelIndex(const TriangleMesh& mesh, const Execution& execution = {});
  // The same, faster where both meshes are closed and connected: there only the edges at triangles
  // that came or went are linked. Precondition: `before.index` is that of a mesh equal to
  // `before.mesh`, and `mesh` is what `before.change` made of it, with finite points.
  ModelIndex(const TriangleMesh& mesh, const IndexBefore& before);

  // The same for a mesh that is known to be connected and closed, with one umbrella at each vertex
  // and no two equal points: its triangles are linked, and no more. Complexity: O(t + v), in part
  // parallel.
  static ModelIndex of_smooth(const TriangleMesh& mesh, const Execution& execution = {});
  // Whether the mesh of an index by of_smooth() is connected and closed, with one umbrella at each
  // vertex: for meshes from files. Complexity: O(t + v), in part parallel.
  bool is_really_smooth(const Execution& execution = {}) const;
  // What edit() has to know of an edit of the mesh: what went and came, in the mesh before and
  // after, and where all the others are now (places_after).
  struct Edit {
    const ListEdit<VertexId>& vertices;
    const ListEdit<TriangleId>& triangles;
    const IdVector<TriangleId, TriangleId>& triangle_map;
  };
  // Follows an edit of the mesh, which has been carried out. Precondition: before and after it is
  // as of_smooth() demands; triangles that stay have their corners in the same order. Complexity:
  // O(t + v), a pass in place over each list, and sorting what is new.
  void edit(const Edit& edit);
  // Makes it is_known_smooth(), so that it can be edited. Precondition: the mesh is as of_smooth()
  // demands. Complexity: O(t + v).
  void prepare_for_edits();

  const TriangleMesh& mesh() const { return *mesh_; }
  const TriangleNeighbors& neighbors() const { return neighbors_; }
  // The triangles that have the vertex as a corner, in the order of their ids. Complexity:
  // O(triangles found), a bit more for sorting.
  std::vector<TriangleId> triangles_at(VertexId v) const;
  // Calls visit(triangle) for each of them, in any order, without making a list.
  template <class Visit>
  void for_each_triangle_at(VertexId v, Visit visit) const {
    if (!is_known_smooth()) {
      for (const TriangleId t : at_vertices_[v]) visit(t);
      return;
    }
    const TriangleId first = triangle_at_[v];
    TriangleId t = first;
    do {
      visit(t);
      t = next_around(v, t);
    } while (t != first);
  }
  // Calls visit(vertex) for each vertex in the box, ascending. Complexity: O(v).
  template <class Visit>
  void for_each_vertex_in(const Box& box, const Visit& visit) const {
    const auto& points = mesh_->points;
    if (is_known_smooth()) return cells_.visit_in(box, points, visit);
    visit_where(
        points.size(), [&](std::size_t i) { return contains(box, points[VertexId(i)]); },
        [&](std::size_t i) { visit(VertexId(i)); });
  }
  // Whether a triangle has the vertex.
  bool is_used(VertexId v) const {
    return is_known_smooth() ? !triangle_at_[v].is_none() : !at_vertices_[v].empty();
  }
  // Whether it is known that each edge has two triangles, and each vertex triangles that hang
  // together by these. Not of a mesh that merely is so: by of_smooth() or prepare_for_edits().
  bool is_known_smooth() const { return !triangle_at_.empty(); }
  // No edge is longer than this along any axis. Infinity: not known.
  double longest_extent() const { return longest_extent_; }
  // Unit normal, outward if the mesh is oriented; the zero vector for a facet without area.
  Vec3 normal(TriangleId t) const;
  Point centroid(TriangleId t) const;
  // Facets connected across edges (with no third facet) have the same number.
  std::uint32_t component(TriangleId t) const { return is_connected() ? 0 : components_[t]; }
  // Whether all facets are.
  bool is_connected() const { return components_.empty(); }
  // Whether it is known that the mesh has no two equal points.
  bool has_distinct_points() const { return distinct_points_; }

 private:
  ModelIndex() = default;
  // The triangle after t on the way around one of its corners.
  TriangleId next_around(VertexId v, TriangleId t) const {
    const Triangle& corners = mesh_->triangles[t];
    return neighbors_[t][corners[0] == v ? 1 : corners[1] == v ? 2 : 0];
  }
  std::size_t corners_around(VertexId v, std::size_t most) const;
  void link_open_edges(std::span<const TriangleId> triangles);
  void take_in_size(TriangleId t);

  const TriangleMesh* mesh_ = nullptr;
  TriangleNeighbors neighbors_;
  TrianglesAtVertices at_vertices_;                 // not if smooth
  IdVector<VertexId, TriangleId> triangle_at_;      // if smooth: one of those at the vertex
  GridCells cells_;                                 // if smooth: of the vertices
  IdVector<TriangleId, std::uint32_t> components_;  // empty: all are of one
  bool distinct_points_ = false;
  double longest_extent_ = std::numeric_limits<double>::infinity();  // if smooth: a bound
};

}  // namespace cocoon
