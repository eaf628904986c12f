// A mesh with what the stages of the update ask of its facets: neighbors, normals, parts.
#pragma once

#include <cstdint>

#include "geom/id_vector.h"
#include "geom/mesh_adjacency.h"
#include "geom/triangle_mesh.h"
#include "update/mesh_change.h"

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
  // not there or has a coordinate that is not finite. Complexity: O(t + v).
  explicit ModelIndex(const TriangleMesh& mesh);
  // The same, faster where both meshes are closed and connected: there only the sides at triangles
  // that came or went are linked. Precondition: `before.index` is that of a mesh equal to
  // `before.mesh`, and `mesh` is what `before.change` made of it, with finite points.
  ModelIndex(const TriangleMesh& mesh, const IndexBefore& before);

  const TriangleMesh& mesh() const { return *mesh_; }
  // Without edges (mesh_neighbors).
  const MeshAdjacency& adjacency() const { return adjacency_; }
  // Unit normal, outward if the mesh is oriented; the zero vector for a facet without area.
  Vec3 normal(TriangleId t) const;
  Point centroid(TriangleId t) const;
  // Facets connected across edges (with no third facet) have the same number.
  std::uint32_t component(TriangleId t) const { return is_connected() ? 0 : components_[t]; }
  // Whether all facets are.
  bool is_connected() const { return components_.empty(); }
  // Whether the mesh has no two equal points.
  bool has_distinct_points() const { return distinct_points_; }

 private:
  const TriangleMesh* mesh_;
  MeshAdjacency adjacency_;
  IdVector<TriangleId, std::uint32_t> components_;  // empty: all are of one
  bool distinct_points_ = false;
};

}  // namespace cocoon
