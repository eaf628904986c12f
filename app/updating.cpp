#include "app/updating.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/arguments/update_options.h"
#include "app/files/carried_properties.h"
#include "app/report/html_report.h"
#include "app/report/lost_surface_report.h"
#include "app/report/surface_report.h"
#include "app/report/update_findings.h"
#include "app/report/update_report.h"
#include "app/report/verification.h"
#include "app/shapes/make_manifold.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"
#include "geom/search/nearest_point.h"
#include "geom/signed_distance.h"
#include "io/atomic_file.h"
#include "io/mesh_file.h"
#include "update/report/cloud_report.h"
#include "update/report/update_messages.h"
#include "update/report/vertex_origins.h"

namespace cocoon::app {

namespace {

// Where the vertices of the model's file went.
IdVector<VertexId, VertexId> map_of_file(const UpdateInput& input,
                                         const IdVector<VertexId, VertexId>& vertex_map) {
  if (input.vertex_of_file.empty()) return vertex_map;
  IdVector<VertexId, VertexId> map(input.vertex_of_file.size());
  for (const VertexId v : map.ids()) {
    const VertexId of_model = input.vertex_of_file[v];
    if (!of_model.is_none()) map[v] = vertex_map[of_model];
  }
  return map;
}

std::string map_text(const IdVector<VertexId, VertexId>& vertex_map) {
  std::string text;
  for (const VertexId vertex : vertex_map) {
    text += vertex.is_none() ? std::string("-1\n") : fmt::format("{}\n", vertex.value);
  }
  return text;
}

VertexProperties properties_of_update(Job& job, const UpdateInput& input,
                                      const UpdateResult& result) {
  if (input.properties.empty()) return {};
  std::vector<std::string> names = {input.model_name};
  names.insert(names.end(), input.cloud_names.begin(), input.cloud_names.end());
  std::vector<RowOrigin> origins;
  for (const VertexOrigin& origin : vertex_origins(result)) {
    origins.push_back({origin.input, origin.index});
  }
  return carried_properties(job, input.properties, names, origins);
}

// The signed distances from the model of the points of each cloud, and of what --manifold added.
std::vector<std::vector<double>> deviation(Job& job, const UpdateInput& input,
                                           const UpdateResult& result) {
  std::vector<std::vector<double>> distances;
  const auto add = [&](Points points) {
    distances.push_back(signed_distances(input.model, points, {job.execution().threads}));
  };
  for (const std::vector<Point>& cloud : input.clouds) add(cloud);
  add(Points(result.mesh.points.raw()).subspan(result.reconstruction.point_of_vertex.size()));
  return distances;
}

// Whether new samples lie near one of the places: within three times its size, since a group of
// doubtful samples, which is named by its worst place, reaches farther than that.
bool is_at_samples(const Finding& finding, const std::vector<std::vector<Point>>& clouds) {
  return std::any_of(clouds.begin(), clouds.end(), [&](const std::vector<Point>& cloud) {
    constexpr double reach = 3;
    const NearestPointTree samples(cloud);
    return std::any_of(finding.spots.begin(), finding.spots.end(), [&](const DoubtfulSpot& spot) {
      return samples.any_near(spot.at, reach * spot.size);
    });
  });
}

// Adds what is doubtful about the updated surface to the report and to the warnings, or to `notes`;
// where samples are sparse only at the new ones: the model has the others from before, and they
// would be said each time. Returns the certificate of the surface.
MeshReport report_doubts(Job& job, const UpdateInput& input, UpdateResult& result,
                         NoiseFilter filter, bool parted, std::vector<std::string>& notes) {
  ReconstructResult& surface = result.reconstruction;
  surface.mesh = std::move(result.mesh);
  MeshReport certificate;
  std::vector<Finding> findings = findings_of_update(surface, result.replacement.points, filter, {},
                                                     job.execution(), certificate);
  result.mesh = std::move(surface.mesh);
  surface.mesh = {};
  std::erase_if(findings, [&](const Finding& f) { return parted && f.kind == "contacts"; });
  add_findings(job.report(), findings);
  for (const Finding& finding : findings) {
    if (finding.kind == "sparse" && !is_at_samples(finding, input.clouds)) continue;
    (finding.warns ? result.warnings : notes).push_back(finding.message);
  }
  return certificate;
}

// What the session keeps of its last update.
void add_surface_of(const UpdateSession& session, UpdateResult& result) {
  result.reconstruction = session.reconstruction();
  result.mesh = session.model();
  result.replacement.points.assign(session.points().begin(), session.points().end());
}

// The program has an option for what this message advises.
std::string with_option_names(std::string message) {
  const std::size_t at = message.find(advice_of_groups);
  if (at != std::string::npos) message.insert(at + advice_of_groups.size(), " by --replace-groups");
  return message;
}

void add_overrides(JsonReport& report, const RegionOverrides& overrides) {
  const auto add = [&](const char* path, const std::vector<RegionId>& regions) {
    if (!regions.empty()) report.set(path, numbers_of(regions));
  };
  add("parameters/replace_groups", overrides.replaced);
  add("parameters/keep_groups", overrides.kept);
}

}  // namespace

UpdateOutcome updated(Job& job, const UpdateInput& input, const UpdateOptions& options,
                      UpdateSession* session) {
  UpdateOutcome outcome;
  try {
    if (session == nullptr) {
      outcome.update.result = update_model(input.model, input.clouds, options, job.execution());
    } else {
      outcome.update = session->apply(input.clouds, options.overrides, job.execution());
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot update {}: {}", input.model_name,
                                 with_cloud_names(error.what(), input.cloud_names)));
  }
  auto& [result, change] = outcome.update;
  if (result.status != UpdateStatus::ok) return outcome;
  if (session != nullptr) add_surface_of(*session, result);
  timed(job.execution(), "check", [&] {
    if (session == nullptr) change = mesh_change(input.model, result.mesh, result.vertex_map);
    const std::vector<Scan> scans = scans_of(input.clouds, result.clouds);
    outcome.lost = lost_surface(input.model, scans, result, change, result.mesh);
  });
  return outcome;
}

void write_update(Job& job, const UpdateInput& input, UpdateOutcome outcome,
                  const UpdateOptions& options, const UpdateOutput& output) {
  UpdateResult& result = outcome.update.result;
  report_verification(job.report(), input.model_name, result.reconstruction.verification);
  if (result.status != UpdateStatus::ok) {
    throw InputError(
        fmt::format("cannot update {} ({}): {}", input.model_name, name_of(result.status),
                    with_option_names(with_cloud_names(result.message, input.cloud_names))));
  }
  add_lost_surface(job.report(), outcome.lost);
  if (outcome.lost.warns) {
    result.warnings.push_back(
        warning_of_lost_surface(outcome.lost, outcome.tried, input.model_name, input.model));
  }
  if (outcome.lost.makes_up) {
    result.warnings.push_back(warning_of_made_up_surface(outcome.lost, input.model_name));
  }
  for (std::string& warning : result.warnings) {
    warning = with_option_names(with_cloud_names(warning, input.cloud_names));
  }
  const NoiseFilter filter = noise_filter_of_update(!input.strays.empty());
  std::vector<std::string> notes = notes_of_clouds(result, input.cloud_names, options);
  MeshReport certificate = timed(job.execution(), "check", [&] {
    return report_doubts(job, input, result, filter, output.manifold, notes);
  });
  VertexProperties properties = properties_of_update(job, input, result);
  if (output.manifold) {
    certificate = make_manifold(job, {output.mesh, output.keeps_session}, result.mesh, properties);
  }
  UpdateRecord record{input.model_name, input.model, input.cloud_names,
                      input.clouds,     result,      certificate};
  record.strays = input.strays;
  record.overrides = options.overrides;
  add_update(job.report(), record);
  add_update_parameters(job.report(), options);
  add_overrides(job.report(), options.overrides);
  say_update(job, record);
  for (const std::string& note : notes) job.say("note: {}", note);
  for (const std::string& warning : result.warnings) job.warn(warning);

  if (!output.html.empty()) {
    timed(job.execution(), "deviation", [&] { record.deviation = deviation(job, input, result); });
  }
  timed(job.execution(), "write", [&] {
    write_mesh(output.mesh, result.mesh, properties, output.writing, job.outputs());
    if (!output.map.empty()) {
      write_file(output.map, map_text(map_of_file(input, result.vertex_map)), job.outputs());
    }
    if (!output.html.empty()) {
      job.warn_of_rounding(*job.outputs());
      job.complete_report();
      const ReportPage page = update_page(record, job.timings(), job.warnings());
      write_file(output.html, html_page(page, job.report()), job.outputs());
    }
  });
  job.say_outputs("{} -> {}", surface_summary(certificate), output.mesh);
}

}  // namespace cocoon::app
