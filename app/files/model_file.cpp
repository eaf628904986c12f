#include "app/files/model_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "app/files/files.h"
#include "geom/mesh/repeated_triangles.h"
#include "geom/mesh/used_vertices.h"
#include "geom/mesh/weld_vertices.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "geom/search/equal_points.h"
#include "update/model/orient_outward.h"

namespace cocoon::app {

namespace {

// Of each point of a file, which of the `left` it is; of those that were skipped none.
IdVector<VertexId, VertexId> without(const std::vector<std::size_t>& skipped, std::size_t left) {
  IdVector<VertexId, VertexId> vertex_of(left + skipped.size());
  auto next_skipped = skipped.begin();
  std::size_t next = 0;
  for (const VertexId of_file : vertex_of.ids()) {
    if (next_skipped != skipped.end() && *next_skipped == of_file.index()) {
      ++next_skipped;
    } else {
      vertex_of[of_file] = VertexId(next++);
    }
  }
  return vertex_of;
}

// Takes vertices at equal places as one, if that leaves fewer open edges; else returns false.
// `left_out`: faces that the user was told of.
bool weld(Job& job, const std::string& path, const std::string& section,
          const std::vector<RepeatedPoint>& repeated, std::size_t left_out, ModelFile& model,
          VertexProperties* properties) {
  if (repeated.empty()) return false;
  const std::size_t open = mesh_check(model.mesh, {}, job.execution()).open_edges;
  if (open == 0) return false;
  WeldedMesh welded = weld_vertices(model.mesh, repeated);
  if (mesh_check(welded.mesh, {}, job.execution()).open_edges >= open) return false;

  job.report().set(section + "/welded_vertices", welded.welded);
  job.say(
      "{}: {} at the place of another one taken as one with it, since triangles do not share "
      "vertices there",
      path, counted(welded.welded, "vertex", "vertices"));
  warn_of_left_out_faces(job, path, section, left_out, welded.left_out_triangles);
  if (properties != nullptr) *properties = select_rows(*properties, welded.source.span());
  model = {std::move(welded.mesh), std::move(welded.vertex_of)};
  return true;
}

void leave_out_repeated(Job& job, const std::string& path, const std::string& section,
                        const std::vector<RepeatedPoint>& repeated, TriangleMesh& mesh) {
  const std::size_t gone = leave_out_repeated_triangles(mesh, repeated, job.execution());
  if (gone == 0) return;
  job.report().set(section + "/repeated_triangles", gone);
  job.warn(fmt::format("{}: {} at the place of another one, and left out", path,
                       counted(gone, "triangle is", "triangles are")));
}

}  // namespace

ModelFile read_model(Job& job, const std::string& path, const std::string& section,
                     VertexProperties* properties) {
  Shape shape = read_shape(job, path, section, properties);
  ModelFile model{std::move(shape.mesh), {}};
  const std::vector<std::size_t>& skipped = shape.read.skipped;
  if (!skipped.empty()) model.vertex_of = without(skipped, model.mesh.points.size());
  if (model.mesh.triangles.empty()) return model;
  std::vector<RepeatedPoint> repeated = repeated_points(model.mesh.points.span());
  if (weld(job, path, section, repeated, shape.read.left_out(), model, properties)) {
    repeated.clear();
  }
  leave_out_repeated(job, path, section, repeated, model.mesh);
  return model;
}

void leave_out_unused_vertices(Job& job, const std::string& path, const std::string& section,
                               ModelFile& model, VertexProperties* properties) {
  const IdVector<VertexId, std::uint8_t> used = used_vertices(model.mesh);
  if (std::find(used.begin(), used.end(), std::uint8_t{0}) == used.end()) return;
  const std::vector<RepeatedPoint> repeated = repeated_points(model.mesh.points.span());
  IdVector<VertexId, VertexId> now = leave_out_unused(model.mesh);
  if (properties != nullptr) *properties = select_properties(*properties, used.span());
  for (const RepeatedPoint& r : repeated) {
    VertexId& first = now[VertexId(r.first)];
    if (first.is_none()) first = now[VertexId(r.point)];
  }
  auto alone = static_cast<std::size_t>(std::count(now.begin(), now.end(), VertexId()));
  for (const RepeatedPoint& r : repeated) {
    VertexId& other = now[VertexId(r.point)];
    if (!other.is_none()) continue;
    other = now[VertexId(r.first)];
    --alone;  // its place is told once, or used
  }
  if (model.vertex_of.empty()) {
    model.vertex_of = std::move(now);
  } else {
    for (VertexId& v : model.vertex_of) v = v.is_none() ? v : now[v];
  }
  if (alone == 0) return;
  job.report().set(section + "/unused_vertices", alone);
  job.warn(fmt::format(
      "{}: {} in no triangle, and left out; if they are samples of the surface, reconstruct it "
      "from its points, or give them as a cloud",
      path, counted(alone, "vertex is", "vertices are")));
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
