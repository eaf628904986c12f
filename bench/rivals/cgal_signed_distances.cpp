#include "bench/rivals/cgal_signed_distances.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <cmath>

namespace cocoon::rivals {

std::vector<double> cgal_signed_distances(const TriangleMesh& mesh, Points points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  Mesh surface;
  for (const Point& p : mesh.points) surface.add_vertex({p.x, p.y, p.z});
  for (const Triangle& t : mesh.triangles) {
    surface.add_face(Mesh::Vertex_index(t[0].value), Mesh::Vertex_index(t[1].value),
                     Mesh::Vertex_index(t[2].value));
  }
  Tree tree(faces(surface).begin(), faces(surface).end(), surface);
  tree.accelerate_distance_queries();
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(tree);
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Point& p : points) {
    const Kernel::Point_3 query(p.x, p.y, p.z);
    const double distance = std::sqrt(tree.squared_distance(query));
    distances.push_back(side(query) == CGAL::ON_BOUNDED_SIDE ? -distance : distance);
  }
  return distances;
}

}  // namespace cocoon::rivals
