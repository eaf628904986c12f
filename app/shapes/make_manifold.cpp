#include "app/shapes/make_manifold.h"

#include <utility>
#include <vector>

#include "geom/mesh/split_nonmanifold.h"
#include "geom/messages/counted.h"
#include "io/file_format.h"

namespace cocoon::app {

namespace {

VertexProperties properties_of_copies(const VertexProperties& properties,
                                      const IdVector<VertexId, VertexId>& source) {
  if (properties.columns.empty()) return properties;
  return select_rows(properties, source.span());
}

void split_sheets(Job& job, const ManifoldOutput& output, TriangleMesh& mesh,
                  VertexProperties& properties) {
  SplitSurface split = timed(job.execution(), "manifold", [&] { return split_nonmanifold(mesh); });
  job.report().set("manifold/split_edges", split.split_edges);
  job.report().set("manifold/split_vertices", split.split_vertices);
  job.report().set("manifold/copied_vertices", split.copies);
  job.report().set("manifold/midpoints", split.midpoints);
  job.report().set("manifold/unpaired_sides", split.unpaired_halfedges);
  mesh = std::move(split.mesh);
  if (split.copies + split.midpoints == 0) return;
  properties = properties_of_copies(properties, split.source);
  job.say(
      "made manifold: {} with more than two triangles and {} split; {} copied, {} given a midpoint",
      counted(split.split_edges, "edge"), counted(split.split_vertices, "vertex", "vertices"),
      counted(split.copies, "vertex", "vertices"), counted(split.midpoints, "edge"));
  if (split.copies > 0 && format_of(output.file) == FileFormat::stl) {
    job.warn(output.file +
             ": STL has no vertex ids, so a reader joins the copied vertices again; write .ply, "
             ".obj or .off to keep the surface manifold");
  }
  if (output.beside_session)
    job.say("note: the session has the surface as it was before --manifold");
}

}  // namespace

MeshReport make_manifold(Job& job, const ManifoldOutput& output, TriangleMesh& mesh,
                         VertexProperties& properties) {
  split_sheets(job, output, mesh, properties);
  return timed(job.execution(), "check", [&] { return mesh_check(mesh, {}, job.execution()); });
}

}  // namespace cocoon::app
