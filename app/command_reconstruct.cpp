#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/surface_options.h"
#include "app/arguments/thresholds.h"
#include "app/arguments/update_options.h"
#include "app/commands.h"
#include "app/files/carried_properties.h"
#include "app/files/files.h"
#include "app/files/pending_clouds.h"
#include "app/files/session_file.h"
#include "app/report/findings.h"
#include "app/report/reconstruct_report.h"
#include "app/report/surface_report.h"
#include "app/shapes/densify.h"
#include "app/shapes/make_manifold.h"
#include "app/shapes/open_surface.h"
#include "app/shapes/thin_cloud.h"
#include "cocone/reconstruct.h"
#include "cocone/robust_cocone.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "io/lock_file.h"
#include "io/mesh_file.h"

namespace cocoon::app {

namespace {

// `taken_away_by`: none if nothing is.
void warn_of_idle(Job& job, const std::vector<std::string>& names, const char* taken_away_by) {
  if (names.empty() || taken_away_by == nullptr) return;
  job.warn(fmt::format("{} {} nothing with {}", fmt::join(names, ", "),
                       names.size() == 1 ? "does" : "do", taken_away_by));
}

// What leaves out the clean-up; none: nothing.
const char* without_clean_up(const ReconstructArguments& arguments) {
  if (arguments.parameters.mode == Mode::paper) return "--mode paper";
  return arguments.clean_up ? nullptr : "--no-clean-up";
}

const char* without_second_look(const ReconstructArguments& arguments) {
  if (const char* option = without_clean_up(arguments)) return option;
  if (!arguments.second_look) return "--no-second-look";
  return arguments.radius ? "--radius" : nullptr;
}

// Given options that say what others take away.
void warn_of_idle_options(Job& job, const ReconstructArguments& arguments) {
  std::vector<std::string> names;
  if (arguments.parameters.mode == Mode::paper) {
    if (arguments.cavities) names.push_back("--cavities");
    if (arguments.radius == RadiusMode::tangent_plane) names.push_back("--radius tangent-plane");
  }
  append_given(ThresholdUse::clean_up, arguments.thresholds, names);
  warn_of_idle(job, names, without_clean_up(arguments));
  warn_of_idle(job, given_thresholds(ThresholdUse::second_look, arguments.thresholds),
               without_second_look(arguments));
}

StageOptions options_of(const ReconstructArguments& arguments) {
  StageOptions options;
  options.surface = surface_options(arguments.parameters, arguments.surface == SurfaceKind::tight
                                                              ? ReconstructOptions()
                                                              : open_cloud_defaults());
  if (arguments.radius) options.surface.boundary.radius_mode = *arguments.radius;
  options.surface.peel.deferred_seeding = arguments.deferred_seeding;
  options.surface.second_look.enabled = arguments.second_look && !arguments.radius;
  options.surface.clean_up.enabled = arguments.clean_up;
  options.surface.keep_cavities = arguments.cavities;
  options.noise.keep_good = arguments.noise_keep_good;
  options.noise.spare_good = arguments.noise_spare_good;
  set_thresholds(options, arguments.thresholds);
  require_order(options);
  return options;
}

void add_stages(JsonReport& report, const ReconstructArguments& arguments,
                const StageOptions& options) {
  if (arguments.trim) report.set("parameters/trim", *arguments.trim);
  add_parameters(report, options.surface);
  add_thresholds(report, ThresholdUse::cocone, options);
  add_thresholds(report, ThresholdUse::findings, options);
  if (arguments.noise == NoiseHandling::robust) {
    add_thresholds(report, ThresholdUse::outliers, options);
    add_thresholds(report, ThresholdUse::noise, options);
    report.set("parameters/noise_keep_good", options.noise.keep_good);
    report.set("parameters/noise_spare_good", options.noise.spare_good);
  }
  if (arguments.surface != SurfaceKind::tight) return;
  add_thresholds(report, ThresholdUse::tight, options);
  add_thresholds(report, ThresholdUse::second_look, options);
  add_thresholds(report, ThresholdUse::clean_up, options);
  const ReconstructOptions effective = effective_options(options.surface);
  report.set("parameters/deferred_seeding", effective.peel.deferred_seeding);
  report.set("parameters/second_look", effective.second_look.enabled);
  report.set("parameters/cavities", effective.keep_cavities);
  report.set("parameters/clean_up", effective.clean_up.enabled);
}

// Sessions and open surfaces have none (option_rules.h).
NoiseFilter noise_filter_of(const ReconstructArguments& arguments, std::size_t faces) {
  if (arguments.noise == NoiseHandling::robust) return NoiseFilter::used;
  const bool possible = arguments.surface == SurfaceKind::tight && arguments.session.empty();
  if (possible && arguments.densify) return NoiseFilter::no_noise;
  if (!possible) return NoiseFilter::no_option;
  return faces > 0 ? NoiseFilter::not_used_on_mesh : NoiseFilter::not_used;
}

SurfaceRemedies remedies_of(NoiseFilter filter, std::size_t faces) {
  return {.noise_filter = is_filter_left(filter),
          .other = faces > 0 ? std::string(", ") + remedy_of_mesh : std::string()};
}

bool is_trim_left(const ReconstructArguments& arguments) {
  return arguments.surface == SurfaceKind::tight && arguments.session.empty() &&
         !arguments.densify && !arguments.trim;
}

std::vector<Finding> findings_of_surface(const SurfaceDoubts& doubts, std::size_t points,
                                         const ReconstructArguments& arguments, std::size_t faces,
                                         std::size_t trimmed) {
  const bool cavities_may_help = !arguments.cavities && arguments.parameters.mode != Mode::paper;
  return findings_of(
      doubts, points, noise_filter_of(arguments, faces), {},
      {.cavities = cavities_may_help, .trim = is_trim_left(arguments), .trimmed_points = trimmed});
}

// `faces`: those of the file, if their vertices alone are the samples.
DensifiedMesh read_input(Job& job, const ReconstructArguments& arguments,
                         VertexProperties* properties, std::size_t& faces) {
  if (arguments.densify) {
    DensifiedMesh dense = read_densified(job, arguments.points, *arguments.densify, properties);
    if (properties != nullptr) *properties = properties_of_samples(*properties, dense.points);
    return dense;
  }
  DensifiedMesh input;
  input.points = read_cloud(job, arguments.points, "input", properties, &faces);
  require_replaceable(arguments.mesh, arguments.points, faces);
  add_thinning(job.report(), arguments.thin,
               thin_input(job, arguments.points, arguments.thin, input.points, properties));
  return input;
}

// `findings`: what is to be told of the filter.
ReconstructResult without_noise(Job& job, const std::vector<Point>& points,
                                const StageOptions& options, std::vector<Finding>& findings) {
  RobustResult result = reconstruct_robust(points, options.noise, options.surface, job.execution());
  add_noise(job.report(), result.noise);
  job.say("noise: {}, {} in clumps and {} inside the layer left out",
          counted(result.noise.outliers, "outlier"), counted(result.noise.clump_samples, "point"),
          counted(result.noise.layer_samples, "point"));
  if (result.noise.clumps > 0) findings.push_back(clumps_finding(result.noise, points));
  return std::move(result.surface);
}

ReconstructResult begin_session(Job& job, const ReconstructArguments& arguments,
                                const DensifiedMesh& input, const ReconstructOptions& options,
                                std::optional<UpdateSession>& session) {
  UpdateOptions update = update_options(arguments.parameters);
  update.reconstruct = options;
  session.emplace(input.points, update, job.execution(), input.labels);
  ReconstructResult result = session->reconstruction();
  result.mesh = session->model();
  return result;
}

void write_session(Job& job, const ReconstructArguments& arguments, UpdateSession&& session) {
  timed(job.execution(), "write", [&] {
    SessionSnapshot snapshot = std::move(session).release();
    // What is known of the samples holds for this rho, and updates judge them by the usual one.
    if (arguments.parameters.rho) snapshot.surface = {};
    save_session(arguments.session, {std::move(snapshot), arguments.parameters, {}}, job.outputs());
  });
}

// Contacts that --manifold has parted are none any more, and handles that the mesh of the samples
// (--densify) has, too, are meant.
void drop_settled(const MeshReport& surface, const MeshReport& mesh,
                  std::vector<Finding>& findings) {
  const bool parted = surface.edge_manifold && surface.vertex_manifold;
  const bool meant =
      mesh.genus && mesh.genus == surface.genus && mesh.components == surface.components;
  std::erase_if(findings, [&](const Finding& f) {
    return (parted && f.kind == "contacts") || (meant && f.kind == "handles");
  });
}

}  // namespace

void run(const ReconstructArguments& arguments, Job& job) {
  const OutputFile session_file = {.path = arguments.session, .is_session = true};
  require_outputs(job, {{arguments.mesh, mesh_extensions, arguments.points}, session_file},
                  {arguments.points});
  std::optional<LockFile> lock;
  if (!arguments.session.empty()) lock.emplace(arguments.session);
  const bool tight = arguments.surface == SurfaceKind::tight;
  StageOptions stages = options_of(arguments);
  const ReconstructOptions& options = stages.surface;
  VertexProperties properties;
  const bool keep = holds_properties(arguments.mesh);
  std::size_t faces = 0;
  const DensifiedMesh input = read_input(job, arguments, keep ? &properties : nullptr, faces);
  const std::vector<Point>& points = input.points;
  if (input.has_hollow) stages.surface.keep_cavities = true;
  std::optional<UpdateSession> session;
  std::vector<Finding> findings;
  ReconstructResult result = naming_input(arguments.points, [&] {
    if (!arguments.session.empty()) {
      return begin_session(job, arguments, input, options, session);
    }
    if (arguments.noise == NoiseHandling::robust)
      return without_noise(job, points, stages, findings);
    return tight ? reconstruct_tight_with_labels(points, input.labels, options, job.execution())
                 : reconstruct_cocone(points, options, job.execution());
  });
  require_surface(job, arguments.points, result, points, options,
                  remedies_of(noise_filter_of(arguments, faces), faces));
  std::size_t trimmed = 0;
  if (arguments.trim) trimmed = open_surface(job, arguments.points, *arguments.trim, result);
  const SurfaceDoubts doubts = timed(job.execution(), "check", [&] {
    return surface_doubts(result, points, stages.doubts, job.execution());
  });
  warn_of_handles(job, arguments.points, input, doubts.certificate);
  properties = properties_of_surface(job, properties, arguments.points, result);
  const MeshReport certificate =
      arguments.manifold
          ? make_manifold(job, {arguments.mesh, session.has_value()}, result.mesh, properties)
          : doubts.certificate;
  timed(job.execution(), "write", [&] {
    write_mesh(arguments.mesh, result.mesh, properties, arguments.writing, job.outputs());
  });
  if (session) write_session(job, arguments, std::move(*session));

  add_stages(job.report(), arguments, stages);
  add_reconstruction(job, result, certificate);
  job.say("{} ({}, {} not on the surface), {}", counted(result.points, "point"),
          counted(result.duplicates, "duplicate"), result.unused_points,
          counted(result.tetrahedra, "tetrahedron", "tetrahedra"));
  job.say_outputs("{} -> {}", surface_summary(certificate), arguments.mesh);
  const std::vector<Finding> of_surface =
      findings_of_surface(doubts, result.points - result.duplicates, arguments, faces, trimmed);
  findings.insert(findings.end(), of_surface.begin(), of_surface.end());
  drop_settled(certificate, input.certificate, findings);
  report_findings(job, findings);
  warn_of_idle_options(job, arguments);
  job.finish();
  if (session) remove_pending_clouds(arguments.session);  // of the session that was there
}

}  // namespace cocoon::app
