#include "bench/quality_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geom/mesh_check.h"
#include "geom/search/closest_facet.h"
#include "geom/surface_distance.h"

namespace cocoon::bench {
namespace {

Vec3 doubled_area_normal(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

// The side does not count: some methods deliver triangles that face either way.
double mean_normal_error_deg(const TriangleMesh& mesh, const TriangleMesh& truth) {
  const ClosestFacetTree tree(truth);
  double sum = 0;
  double area = 0;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Vec3 normal = doubled_area_normal(mesh, t);
    const auto& [a, b, c] = mesh.triangles[t];
    const Point center = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
    const Vec3 true_normal = unit(doubled_area_normal(truth, tree.closest(center).triangle));
    const double cosine = std::min(1.0, std::abs(dot(unit(normal), true_normal)));
    sum += norm(normal) * std::acos(cosine) * 180 / std::numbers::pi;
    area += norm(normal);
  }
  return area > 0 ? sum / area : 0;
}

// Of the surface with a lid on each hole: a hole is no handle.
std::ptrdiff_t genus_of(const MeshReport& report) {
  const auto components = static_cast<std::ptrdiff_t>(report.components);
  const std::ptrdiff_t euler = report.euler + static_cast<std::ptrdiff_t>(report.boundary_curves);
  return components - (euler >= 0 ? euler / 2 : (euler - 1) / 2);
}

}  // namespace

Quality quality_of(const TriangleMesh& mesh, const QualityModel& model) {
  Quality quality;
  std::set<Point> unused(model.points.begin(), model.points.end());
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) unused.erase(mesh.points[v]);
  }
  quality.unused = unused.size();
  quality.triangles = mesh.triangles.size();
  if (mesh.triangles.empty()) return quality;
  const MeshReport report = mesh_check(mesh);
  const MeshReport truth = mesh_check(model.truth);
  quality.closed = report.watertight;
  quality.manifold = report.edge_manifold && report.vertex_manifold;
  quality.extra_components = static_cast<std::ptrdiff_t>(report.components) -
                             static_cast<std::ptrdiff_t>(truth.components);
  quality.extra_genus = genus_of(report) - genus_of(truth);
  const SurfaceDistance distance = surface_distance(mesh, model.truth, {.samples = 30000});
  quality.mean = distance.mean / model.spacing;
  quality.rms = distance.rms / model.spacing;
  quality.max = distance.max / model.spacing;
  quality.normal_deg = mean_normal_error_deg(mesh, model.truth);
  return quality;
}

}  // namespace cocoon::bench
