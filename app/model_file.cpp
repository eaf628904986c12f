#include "app/model_file.h"

#include <utility>
#include <vector>

#include "app/files.h"
#include "geom/counted.h"
#include "geom/equal_points.h"
#include "geom/mesh_check.h"
#include "geom/weld_vertices.h"
#include "update/model/orient_outward.h"

namespace cocoon::app {

ModelFile read_model(Job& job, const std::string& path, const std::string& section,
                     VertexProperties* properties) {
  ModelFile model{read_shape(job, path, section, properties), {}};
  if (model.mesh.triangles.empty()) return model;
  const std::vector<RepeatedPoint> repeated = repeated_points(model.mesh.points.span());
  if (repeated.empty()) return model;
  const std::size_t open = mesh_check(model.mesh, {}, job.execution()).open_edges;
  if (open == 0) return model;
  WeldedMesh welded = weld_vertices(model.mesh, repeated);
  if (mesh_check(welded.mesh, {}, job.execution()).open_edges >= open) return model;

  job.report().set(section + "/welded_vertices", welded.welded);
  job.say(
      "{}: {} at the place of another one taken as one with it, since triangles do not share "
      "vertices there",
      path, counted(welded.welded, "vertex", "vertices"));
  if (properties != nullptr) {
    std::vector<RowOrigin> origins;
    for (const VertexId source : welded.source) origins.push_back({0, source.index()});
    *properties = select_rows(*properties, origins);
  }
  return {std::move(welded.mesh), std::move(welded.vertex_of)};
}

void orient_model(Job& job, const std::string& path, const std::string& section,
                  TriangleMesh& mesh) {
  const std::size_t turned = orient_outward(mesh).turned;
  if (turned == 0) return;
  job.report().set(section + "/turned_triangles", turned);
  job.say("{}: {} of {} turned around, so that the surface faces outward", path,
          counted(turned, "triangle"), mesh.triangles.size());
}

}  // namespace cocoon::app
