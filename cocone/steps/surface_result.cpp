#include "cocone/steps/surface_result.h"

#include <cstddef>
#include <utility>

#include "cocone/checks/verify_surface.h"
#include "geom/messages/require_size.h"
#include "geom/parallel/parallel_reduce.h"
#include "geom/working_scale.h"

namespace cocoon {

SurfaceResult begin_result(const ReconstructInput& input) {
  const Triangulation& triangulation = input.triangulation;
  require_size("reconstruct", "input points of the triangulation",
               triangulation.vertex_of_point().size(), input.points.size());
  SurfaceResult made;
  made.result.points = input.points.size();
  made.result.duplicates = triangulation.num_duplicates();
  made.result.vertices = triangulation.num_vertices();
  made.result.tetrahedra = triangulation.num_finite_cells();
  return made;
}

void enter_mesh(const ReconstructInput& input, const FoundSurface& found, SurfaceMesh mesh,
                SurfaceResult& made, const Execution& execution) {
  ReconstructResult& result = made.result;
  result.mesh = std::move(mesh.mesh);
  result.point_of_vertex = std::move(mesh.point_of_vertex);
  made.triangulation_vertex = std::move(mesh.triangulation_vertex);
  const std::size_t count = result.mesh.points.size();
  result.normals.resize(count);
  result.boundary_sample.resize(count);
  parallel_chunks(execution, count, coarse_grain(count), [&](std::size_t begin, std::size_t end) {
    for (VertexId v(begin); v.index() < end; ++v) {
      const VertexId source = made.triangulation_vertex[v];
      result.mesh.points[v] = input.points[result.point_of_vertex[v].index()];
      result.normals[v] = found.poles.normals[source];
      result.boundary_sample[v] = found.boundary.boundary[source];
    }
  });
  result.unused_points = result.vertices - count;
  result.status = found.boundary.interior() == 0  ? SurfaceStatus::no_surface
                  : result.mesh.triangles.empty() ? SurfaceStatus::empty
                                                  : SurfaceStatus::ok;
}

void verify_result(const ReconstructInput& input, SurfaceKind kind, SurfaceResult& made,
                   const Execution& execution) {
  ReconstructResult& result = made.result;
  if (!input.options.verify || result.status != SurfaceStatus::ok) return;
  result.verification = verify_surface(
      input.triangulation, {result.mesh, result.point_of_vertex, made.triangulation_vertex},
      input.points, {.closed = kind == SurfaceKind::closed, .scale = working_scale(input.points)},
      execution);
  if (result.verification.ok()) return;
  result.status = SurfaceStatus::refuted;
  result.mesh = {};
  result.point_of_vertex = {};
  result.normals = {};
  result.boundary_sample = {};
}

}  // namespace cocoon
