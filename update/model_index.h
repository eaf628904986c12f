// A mesh with what the stages of the update ask of its facets: neighbors, normals, parts.
#pragma once

#include <cstdint>

#include "geom/id_vector.h"
#include "geom/mesh_adjacency.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Refers to a mesh, which must outlive it and not change. Safe to query from many threads.
class ModelIndex {
 public:
  // Throws InputError for a mesh without triangles, or with a triangle that names a vertex that is
  // not there or has a coordinate that is not finite. Complexity: O(t + v).
  explicit ModelIndex(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return *mesh_; }
  // Without edges (mesh_neighbors).
  const MeshAdjacency& adjacency() const { return adjacency_; }
  // Unit normal, outward if the mesh is oriented; the zero vector for a facet without area.
  Vec3 normal(TriangleId t) const;
  Point centroid(TriangleId t) const;
  // Facets connected across edges (with no third facet) have the same number.
  std::uint32_t component(TriangleId t) const { return components_[t]; }

 private:
  const TriangleMesh* mesh_;
  MeshAdjacency adjacency_;
  IdVector<TriangleId, std::uint32_t> components_;
};

}  // namespace cocoon
