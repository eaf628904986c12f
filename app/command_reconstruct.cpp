#include <optional>

#include "app/carried_properties.h"
#include "app/commands.h"
#include "app/files.h"
#include "app/findings.h"
#include "app/make_manifold.h"
#include "app/reconstruct_report.h"
#include "app/session_file.h"
#include "app/surface_options.h"
#include "app/surface_report.h"
#include "app/thresholds.h"
#include "app/updating.h"
#include "cocone/reconstruct.h"
#include "cocone/robust_cocone.h"
#include "geom/mesh_check.h"
#include "io/mesh_file.h"

namespace cocoon::app {

namespace {

// Noise is filtered before anything else is built, which neither the open surface nor a session,
// which keeps the triangulation of all points, has a place for.
void require_possible_noise_filter(const ReconstructArguments& arguments) {
  if (arguments.noise == "none") return;
  if (arguments.surface != "tight") throw UsageError("--noise robust needs --surface tight");
  if (!arguments.session.empty()) {
    throw UsageError("--noise robust cannot be combined with --session");
  }
}

// A session keeps the parameters of surface_options.h, and no others.
ReconstructOptions options_of(const ReconstructArguments& arguments) {
  const bool thresholds =
      !arguments.thresholds.empty() || !arguments.clean_up || arguments.cavities;
  if (thresholds && !arguments.session.empty()) {
    throw UsageError("thresholds of single stages cannot be combined with --session");
  }
  ReconstructOptions options =
      surface_options(arguments.parameters,
                      arguments.surface == "tight" ? ReconstructOptions() : open_cloud_defaults());
  options.clean_up.enabled = arguments.clean_up;
  options.keep_cavities = arguments.cavities;
  set_thresholds(options, arguments.thresholds);
  return options;
}

ReconstructResult without_noise(Job& job, const std::vector<Point>& points,
                                const ReconstructOptions& options) {
  RobustResult result = reconstruct_robust(points, {}, options, job.execution());
  add_noise(job.report(), result.noise);
  job.say("noise: {} outliers and {} points inside the layer left out", result.noise.outliers,
          result.noise.layer_samples);
  return std::move(result.surface);
}

}  // namespace

void run_reconstruct(const ReconstructArguments& arguments, Job& job) {
  require_outputs(job, {{arguments.mesh, mesh_extensions}, {arguments.session, {}}});
  require_possible_noise_filter(arguments);
  const bool tight = arguments.surface == "tight";
  const ReconstructOptions options = options_of(arguments);
  VertexProperties properties;
  const bool keep = holds_properties(arguments.mesh);
  const std::vector<Point> points =
      read_cloud(job, arguments.points, "input", keep ? &properties : nullptr);
  std::optional<UpdateSession> session;
  ReconstructResult result = naming_input(arguments.points, [&] {
    if (!arguments.session.empty()) {
      UpdateOptions update = update_options(arguments.parameters);
      update.reconstruct = options;
      session.emplace(points, update, job.execution());
      ReconstructResult reconstruction = session->reconstruction();
      reconstruction.mesh = session->model();
      return reconstruction;
    }
    if (arguments.noise == "robust") return without_noise(job, points, options);
    return tight ? reconstruct_tight(points, options, job.execution())
                 : reconstruct_cocone(points, options, job.execution());
  });
  require_surface(job.report(), arguments.points, result, options.boundary.rho);
  const SurfaceDoubts doubts = timed(job.execution(), "check", [&] {
    return surface_doubts(result, points, {}, job.execution());
  });
  properties = properties_of_surface(job, properties, arguments.points, result);
  MeshReport certificate = doubts.certificate;
  if (arguments.manifold) {
    make_manifold(job, arguments.mesh, result.mesh, properties);
    certificate = timed(job.execution(), "check",
                        [&] { return mesh_check(result.mesh, {}, job.execution()); });
  }
  timed(job.execution(), "write", [&] {
    write_mesh(arguments.mesh, result.mesh, properties, {.ascii = arguments.ascii}, job.outputs());
  });
  if (session) {
    timed(job.execution(), "write", [&] {
      save_session(arguments.session, {session->snapshot(), arguments.parameters, {}},
                   job.outputs());
    });
  }

  add_parameters(job.report(), options);
  add_thresholds(job.report(), options);
  job.report().set("parameters/cavities", effective_options(options).keep_cavities);
  job.report().set("parameters/clean_up", effective_options(options).clean_up.enabled);
  add_reconstruction(job.report(), result, certificate);
  job.say("{} points ({} duplicates, {} not on the surface), {} tetrahedra", result.points,
          result.duplicates, result.unused_points, result.tetrahedra);
  job.say("{} -> {}", surface_summary(certificate), arguments.mesh);
  std::vector<Finding> findings =
      findings_of(doubts, result.points - result.duplicates, arguments.noise == "robust");
  const bool parted = certificate.edge_manifold && certificate.vertex_manifold;
  std::erase_if(findings, [&](const Finding& f) { return parted && f.kind == "contacts"; });
  report_findings(job, findings);
  job.finish();
}

}  // namespace cocoon::app
