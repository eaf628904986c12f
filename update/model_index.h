// A mesh with what the stages of the update ask it: neighbors, normals, closest facets.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geom/box_tree.h"
#include "geom/closest_facet.h"
#include "geom/id_vector.h"
#include "geom/mesh_adjacency.h"
#include "geom/nearest_point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Refers to a mesh, which must outlive it and not change. Safe to query from many threads.
class ModelIndex {
 public:
  // Throws InputError for a mesh without triangles, or with a triangle that names a vertex that is
  // not there or has a coordinate that is not finite. Complexity: O(t log t).
  explicit ModelIndex(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return *mesh_; }
  const MeshAdjacency& adjacency() const { return adjacency_; }
  // Unit normal, outward if the mesh is oriented; the zero vector for a facet without area.
  const Vec3& normal(TriangleId t) const { return normals_[t]; }
  Point centroid(TriangleId t) const;
  // Facets connected across edges (with no third facet) have the same number.
  std::uint32_t component(TriangleId t) const { return components_[t]; }

  // The facet closest to p for which accept(t) holds, at a squared distance of at most `bound`;
  // triangle `none` if there is none. Ties by lexicographic corners, then by id.
  // Complexity: O(log t) on ordinary meshes.
  template <class Accept>
  ClosestFacet closest(const Point& p, double bound, const Accept& accept) const {
    ClosestFacet best;
    best.squared_distance = bound;
    facets_.visit_near(p, bound, [&](std::uint32_t slot) {
      const TriangleId t(facets_.items()[slot]);
      if (accept(t)) improve(p, t, best);
      return best.squared_distance;
    });
    return best;
  }
  ClosestFacet closest(const Point& p) const {
    return closest(p, std::numeric_limits<double>::infinity(), [](TriangleId) { return true; });
  }

  // The vertex nearest to p among those that triangles use. Ties by lexicographic coordinates.
  VertexId nearest_vertex(const Point& p) const;

 private:
  void improve(const Point& p, TriangleId t, ClosestFacet& best) const;

  const TriangleMesh* mesh_;
  MeshAdjacency adjacency_;
  IdVector<TriangleId, Vec3> normals_;
  IdVector<TriangleId, std::uint32_t> components_;
  BoxTree facets_;
  std::vector<VertexId> used_vertices_;
  NearestPointTree vertices_;
};

}  // namespace cocoon
