#include "bench/rivals/cgal_surfaces.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Weighted_PCA_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>
#include <array>
#include <iterator>
#include <vector>

namespace cocoon::rivals {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ScaleSpace = CGAL::Scale_space_surface_reconstruction_3<Kernel>;
using Smoother = CGAL::Scale_space_reconstruction_3::Weighted_PCA_smoother<Kernel>;
using Mesher = CGAL::Scale_space_reconstruction_3::Advancing_front_mesher<Kernel>;

std::vector<Kernel::Point_3> to_cgal(Points points) {
  std::vector<Kernel::Point_3> result;
  result.reserve(points.size());
  for (const Point& p : points) result.emplace_back(p.x, p.y, p.z);
  return result;
}

template <class Facets>
TriangleMesh mesh_of(Points points, const Facets& facets) {
  TriangleMesh mesh;
  for (const Point& p : points) mesh.points.push_back(p);
  for (const auto& f : facets) {
    mesh.triangles.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
  }
  return mesh;
}

}  // namespace

TimedSurface cgal_advancing_front(Points points) {
  const std::vector<Kernel::Point_3> input = to_cgal(points);
  std::vector<std::array<std::size_t, 3>> facets;
  TimedSurface result;
  const bench::Stopwatch stopwatch;
  CGAL::advancing_front_surface_reconstruction(input.begin(), input.end(),
                                               std::back_inserter(facets));
  result.elapsed = stopwatch.elapsed();
  result.mesh = mesh_of(points, facets);
  return result;
}

TimedSurface cgal_scale_space(Points points) {
  const std::vector<Kernel::Point_3> input = to_cgal(points);
  TimedSurface result;
  const bench::Stopwatch stopwatch;
  ScaleSpace reconstruct(input.begin(), input.end());
  reconstruct.increase_scale(4, Smoother());
  reconstruct.reconstruct_surface(Mesher());
  result.elapsed = stopwatch.elapsed();
  const std::vector<std::array<std::size_t, 3>> facets(reconstruct.facets_begin(),
                                                       reconstruct.facets_end());
  result.mesh = mesh_of(points, facets);
  return result;
}

}  // namespace cocoon::rivals
