#include "geom/sharp_edges.h"

namespace cocoon {
namespace {

Vec3 normal_of(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

bool is_sharp(const LinkedMesh& mesh, Halfedge halfedge, double sharp_cosine) {
  if (!mesh.has_two_triangles(halfedge)) return true;
  const Halfedge across = mesh.links[halfedge];
  const Point& a = mesh.points[mesh.from(halfedge)];
  const Point& b = mesh.points[mesh.to(halfedge)];
  const Vec3 here = normal_of(a, b, mesh.points[mesh.apex(halfedge)]);
  const Vec3 there = normal_of(b, a, mesh.points[mesh.apex(across)]);
  return !(dot(here, there) >= sharp_cosine * norm(here) * norm(there));
}

}  // namespace

std::vector<Halfedge> sharp_edges(const LinkedMesh& mesh, double sharp_cosine) {
  std::vector<Halfedge> sharp;
  for (Halfedge halfedge = 0; halfedge < mesh.links.size(); ++halfedge) {
    if (mesh.is_first(halfedge) && is_sharp(mesh, halfedge, sharp_cosine)) {
      sharp.push_back(halfedge);
    }
  }
  return sharp;
}

}  // namespace cocoon
