#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "app/arguments/surface_options.h"
#include "app/arguments/thresholds.h"
#include "app/commands.h"
#include "app/files/carried_properties.h"
#include "app/files/files.h"
#include "app/report/findings.h"
#include "app/report/reconstruct_report.h"
#include "app/report/surface_report.h"
#include "app/shapes/open_surface.h"
#include "app/shapes/thin_cloud.h"
#include "cocone/boundary_loops.h"
#include "cocone/checks/surface_doubts.h"
#include "cocone/literal_boundary.h"
#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "io/mesh_file.h"
#include "io/polyline_file.h"
#include "update/cloud/trim_long_edges.h"

namespace cocoon::app {

namespace {

// The loops as lists of vertices, as the polyline writer wants them.
std::vector<std::vector<VertexId>> vertices_of(const BoundaryLoops& boundary) {
  std::vector<std::vector<VertexId>> loops;
  for (const BoundaryLoop& loop : boundary.loops) {
    loops.emplace_back();
    for (const BoundaryEdge& edge : loop.edges) loops.back().push_back(edge.from);
  }
  return loops;
}

void add_boundary(JsonReport& report, const ReconstructResult& surface,
                  const BoundaryLoops& boundary) {
  report.set("boundary/samples", surface.counters.boundary_samples);
  const LiteralBoundary literal =
      literal_boundary(surface.mesh, link_halfedges(surface.mesh), surface.boundary_sample);
  report.set("boundary/chords", literal.chords);
  report.set("boundary/missed_edges", literal.missed_edges);
  report.set("boundary/pin_holes", boundary.pin_holes);
  report.set("boundary/small_components", boundary.small_components);
  report.set_empty_array("boundary/loops");
  for (const BoundaryLoop& loop : boundary.loops) {
    JsonReport entry;
    entry.set("edges", loop.edges.size());
    entry.set("perimeter", loop.perimeter);
    entry.set("pin_hole", loop.pin_hole);
    report.append("boundary/loops", entry);
  }
}

// Which vertices are boundary samples, beside what the file of points says of them.
void add_boundary_samples(const ReconstructResult& surface, VertexProperties& properties) {
  constexpr const char* name = "boundary_sample";
  std::erase_if(properties.columns,
                [&](const VertexProperty& column) { return column.declaration.name == name; });
  properties.rows = surface.boundary_sample.size();
  properties.columns.push_back(property_of(name, surface.boundary_sample.span()));
}

void say_summary(Job& job, const ReconstructResult& surface, const MeshReport& certificate,
                 const BoundaryLoops& boundary, const std::string& mesh) {
  job.say("{} ({}, {} not on the surface)", counted(surface.points, "point"),
          counted(surface.duplicates, "duplicate"), surface.unused_points);
  job.say_outputs("{} -> {}", surface_summary(certificate), mesh);
  job.say("{}, {} ({})", counted(surface.counters.boundary_samples, "boundary sample"),
          counted(boundary.loops.size(), "loop"), counted(boundary.pin_holes, "pin-hole"));
  for (const BoundaryLoop& loop : boundary.loops) {
    job.say("  {} edges, length {:.6g}{}", loop.edges.size(), loop.perimeter,
            loop.pin_hole ? " (pin-hole)" : "");
  }
}

// That an open surface has boundary samples and edges is no finding.
void tell_unused(Job& job, const SurfaceDoubts& doubts, std::size_t points) {
  std::vector<Finding> findings =
      findings_of(doubts, points, NoiseFilter::no_option, {}, {.cavities = false});
  std::erase_if(findings, [](const Finding& f) { return f.kind != "unused"; });
  report_findings(job, findings);
}

// As an update would take them out.
void tell_bridges(Job& job, const TriangleMesh& surface) {
  const TrimOptions options;
  const TrimmedSurface trimmed = trim_long_edges(surface, options);
  const std::size_t triangles = trimmed.at_rim + trimmed.in_clusters;
  if (triangles == 0) return;
  job.report().set("boundary/bridging_triangles", triangles);
  job.say(
      "note: {} with edges longer than {} times the spacing may bridge slots or holes; --trim {} "
      "leaves them out, as an update does",
      counted(triangles, "triangle"), options.max_edge, options.max_edge);
}

}  // namespace

void run(const BoundaryArguments& arguments, Job& job) {
  require_outputs(
      job, {{arguments.mesh, mesh_extensions, arguments.points}, {arguments.loops, {".obj"}}},
      {arguments.points});
  StageOptions stages;
  stages.surface = surface_options(arguments.parameters, open_cloud_defaults());
  if (arguments.radius) stages.surface.boundary.radius_mode = *arguments.radius;
  set_thresholds(stages, arguments.thresholds);
  const ReconstructOptions& options = stages.surface;
  VertexProperties properties;
  const bool keep = holds_properties(arguments.mesh);
  VertexProperties* const carried = keep ? &properties : nullptr;
  std::size_t faces = 0;
  std::vector<Point> points = read_cloud(job, arguments.points, "input", carried, &faces);
  require_replaceable(arguments.mesh, arguments.points, faces);
  add_thinning(job.report(), arguments.thin,
               thin_input(job, arguments.points, arguments.thin, points, carried));
  ReconstructResult surface = naming_input(
      arguments.points, [&] { return reconstruct_cocone(points, options, job.execution()); });
  require_surface(job, arguments.points, surface, points, options);
  if (arguments.trim) {
    open_surface(job, arguments.points, *arguments.trim, surface);
  } else {
    tell_bridges(job, surface.mesh);
  }
  const BoundaryLoops boundary =
      timed(job.execution(), "loops", [&] { return boundary_loops(surface.mesh, stages.loops); });
  const SurfaceDoubts doubts = timed(job.execution(), "check", [&] {
    return surface_doubts(surface, points, {.place_handles = false}, job.execution());
  });
  const MeshReport& certificate = doubts.certificate;
  properties = properties_of_surface(job, properties, arguments.points, surface);
  if (arguments.label_samples) add_boundary_samples(surface, properties);
  timed(job.execution(), "write", [&] {
    write_mesh(arguments.mesh, surface.mesh, properties, arguments.writing, job.outputs());
    if (!arguments.loops.empty()) {
      write_polylines(arguments.loops, surface.mesh.points.span(), vertices_of(boundary),
                      job.outputs());
    }
  });

  add_parameters(job.report(), options);
  if (arguments.trim) job.report().set("parameters/trim", *arguments.trim);
  for (const ThresholdUse use : {ThresholdUse::cocone, ThresholdUse::loops}) {
    add_thresholds(job.report(), use, stages);
  }
  add_reconstruction(job, surface, certificate);
  add_boundary(job.report(), surface, boundary);
  say_summary(job, surface, certificate, boundary, arguments.mesh);
  tell_unused(job, doubts, surface.points - surface.duplicates);
  if (arguments.parameters.mode == Mode::paper && arguments.radius == RadiusMode::tangent_plane) {
    job.warn("--radius tangent-plane does nothing with --mode paper");
  }
  job.finish();
}

}  // namespace cocoon::app
