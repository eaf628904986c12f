#include "geom/mesh/sharp_edges.h"

#include <algorithm>

#include "geom/triangle_normal.h"

namespace cocoon {
namespace {

bool is_sharp(const LinkedMesh& mesh, Halfedge halfedge, double smooth_cosine) {
  if (!mesh.has_two_triangles(halfedge)) return true;
  const Halfedge across = mesh.links[halfedge];
  const Point& a = mesh.points[mesh.from(halfedge)];
  const Point& b = mesh.points[mesh.to(halfedge)];
  const Vec3 here = area_normal(a, b, mesh.points[mesh.apex(halfedge)]);
  const Vec3 there = area_normal(b, a, mesh.points[mesh.apex(across)]);
  return !(dot(here, there) >= smooth_cosine * norm(here) * norm(there));
}

}  // namespace

std::vector<Halfedge> sharp_edges(const LinkedMesh& mesh, double smooth_cosine) {
  std::vector<Halfedge> sharp;
  for (Halfedge halfedge = 0; halfedge < mesh.links.size(); ++halfedge) {
    if (!mesh.is_last(halfedge)) continue;
    const Halfedge first = mesh.links[halfedge];
    if (is_sharp(mesh, first, smooth_cosine)) sharp.push_back(first);
  }
  std::sort(sharp.begin(), sharp.end());
  return sharp;
}

}  // namespace cocoon
