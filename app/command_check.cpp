#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/arguments/check_requirements.h"
#include "app/commands.h"
#include "app/files/files.h"
#include "app/report/surface_report.h"
#include "geom/errors.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/mesh/narrow_handles.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/messages/place_name.h"
#include "geom/self_intersection.h"

namespace cocoon::app {

namespace {

void say_certificate(Job& job, const Certificate& certificate, const MeshMeasure& measure) {
  const MeshReport& c = certificate.report;
  const auto say = [&job](const char* name, auto value) { job.say("{:<34} {}", name, value); };
  say("vertices", c.vertices);
  say("  without a triangle", c.unused_vertices);
  say("  at the place of another one", c.coincident_vertices);
  say("triangles", c.triangles);
  say("  naming a vertex twice", c.repeated_vertex_triangles + certificate.repeated_vertex_faces);
  say("  without area", c.zero_area_triangles);
  say("  duplicates", c.duplicate_triangles);
  say("edges", c.edges);
  say("  open", c.open_edges);
  say("  with more than two triangles", c.overfull_edges);
  say("  with triangles in conflict", c.orientation_conflicts);
  say("pinched vertices", c.pinched_vertices);
  say("boundary curves", c.boundary_curves);
  say("components", c.components);
  say("Euler characteristic", c.euler);
  say("genus", c.genus ? std::to_string(*c.genus) : std::string("-"));
  say("watertight", c.watertight ? "yes" : "no");
  say("manifold", c.edge_manifold && c.vertex_manifold ? "yes" : "no");
  say("oriented", c.oriented ? "yes" : "no");
  say("area", measure.area);
  say("volume", c.balanced ? fmt::format("{}", measure.signed_volume) : std::string("-"));
  say("median edge", measure.edge_lengths.median);
  if (certificate.self_intersections) {
    say("pairs of triangles that cross", certificate.self_intersections->count);
  }
}

void add_certificate(JsonReport& report, const Certificate& certificate,
                     const MeshMeasure& measure) {
  const MeshReport& c = certificate.report;
  report.set("surface/orientable", c.orientable);
  report.set("surface/edges", c.edges);
  report.set("surface/unbalanced_edges", c.unbalanced_edges);
  report.set("surface/orientation_conflicts", c.orientation_conflicts);
  report.set("surface/boundary_curves", c.boundary_curves);
  report.set("surface/vertex_components", c.vertex_components);
  report.set("surface/unused_vertices", c.unused_vertices);
  report.set("surface/coincident_vertices", c.coincident_vertices);
  report.set("surface/repeated_vertex_triangles",
             c.repeated_vertex_triangles + certificate.repeated_vertex_faces);
  report.set("surface/zero_area_triangles", c.zero_area_triangles);
  report.set("surface/duplicate_triangles", c.duplicate_triangles);
  report.set("surface/area", measure.area);
  if (c.balanced) report.set("surface/volume", measure.signed_volume);
  report.set("surface/edge_length/min", measure.edge_lengths.min);
  report.set("surface/edge_length/median", measure.edge_lengths.median);
  report.set("surface/edge_length/max", measure.edge_lengths.max);
  if (certificate.self_intersections) {
    report.set("surface/self_intersections", certificate.self_intersections->count);
  }
}

// Where a surface with a genus has them.
void tell_handles(Job& job, const TriangleMesh& mesh, const MeshReport& report, std::size_t count) {
  job.report().set_empty_array("surface/handles");
  if (!report.genus) {
    job.say("narrow handles                     - (needs a closed manifold)");
    return;
  }
  const LinkedMesh linked = link_mesh(mesh, job.execution());
  for (const NarrowHandle& handle : narrow_handles(linked, count)) {
    const Point& at = linked.points[handle.path.front()];
    job.say("narrow handle                      {:.6g} around, {} edges, near {}", handle.length,
            handle.path.size(), place_name(at));
    JsonReport entry;
    entry.set("at", std::vector<double>{at.x, at.y, at.z});
    entry.set("length", handle.length);
    entry.set("edges", handle.path.size());
    job.report().append("surface/handles", entry);
  }
}

}  // namespace

void run(const CheckArguments& arguments, Job& job) {
  require_outputs(job, {}, {arguments.mesh});
  const Shape shape = read_shape(job, arguments.mesh, "input");
  const TriangleMesh& mesh = shape.mesh;
  if (mesh.triangles.empty()) {
    throw InputError(arguments.mesh + ": holds no triangles; a mesh is needed");
  }
  Certificate certificate;
  certificate.repeated_vertex_faces = shape.read.degenerate_triangles;
  certificate.short_faces = shape.read.short_faces;
  MeshMeasure measure;
  timed(job.execution(), "check", [&] {
    certificate.report = mesh_check(mesh, {}, job.execution());
    measure = mesh_measure(mesh);
  });
  if (arguments.self_intersections || needs_self_intersections(arguments.required)) {
    certificate.self_intersections = self_intersection(mesh, {}, job.execution());
  }
  const std::vector<std::string> failures =
      failed_requirements(arguments.required, certificate, mesh);

  say_certificate(job, certificate, measure);
  add_surface(job.report(), mesh, certificate.report);
  add_certificate(job.report(), certificate, measure);
  if (arguments.handles > 0) tell_handles(job, mesh, certificate.report, arguments.handles);
  job.report().set("failed_requirements", failures);
  job.finish();
  if (!failures.empty()) {
    throw InputError(fmt::format("{}: {}", arguments.mesh, fmt::join(failures, "; ")));
  }
}

}  // namespace cocoon::app
