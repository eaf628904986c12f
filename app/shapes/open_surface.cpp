#include "app/shapes/open_surface.h"

#include <fmt/format.h>
#include <utility>

#include "geom/errors.h"
#include "geom/mesh/used_vertices.h"
#include "geom/messages/counted.h"
#include "update/cloud/trim_long_edges.h"

namespace cocoon::app {

namespace {

// Those that no triangle has; the others keep their order. Returns how many.
std::size_t drop_unused_vertices(ReconstructResult& surface) {
  const IdVector<VertexId, VertexId> now = leave_out_unused(surface.mesh);
  for (const VertexId v : now.ids()) {
    if (now[v].is_none()) continue;
    surface.point_of_vertex[now[v]] = surface.point_of_vertex[v];
    surface.normals[now[v]] = surface.normals[v];
    surface.boundary_sample[now[v]] = surface.boundary_sample[v];
  }
  const std::size_t left = surface.mesh.points.size();
  surface.point_of_vertex.resize(left);
  surface.normals.resize(left);
  surface.boundary_sample.resize(left);
  return now.size() - left;
}

}  // namespace

std::size_t open_surface(Job& job, const std::string& input, double max_edge,
                         ReconstructResult& surface) {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  timed(job.execution(), "trim", [&] {
    TrimmedSurface trimmed = trim_long_edges(std::move(surface.mesh), {.max_edge = max_edge});
    triangles = trimmed.in_clusters + trimmed.at_rim;
    surface.mesh = std::move(trimmed.mesh);
    if (surface.mesh.triangles.empty()) {
      throw InputError(fmt::format(
          "{}: --trim {} leaves no triangle: all have edges longer than so many spacings; use more",
          input, max_edge));
    }
    vertices = drop_unused_vertices(surface);
  });
  surface.unused_points += vertices;
  job.report().set("trim/triangles", triangles);
  job.report().set("trim/vertices", vertices);
  job.say("{} with edges longer than {} times the spacing left out", counted(triangles, "triangle"),
          max_edge);
  return vertices;
}

}  // namespace cocoon::app
