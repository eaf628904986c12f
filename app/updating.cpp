#include "app/updating.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/arguments/update_options.h"
#include "app/files/carried_properties.h"
#include "app/report/html_report.h"
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
#include "update/report/lost_triangles.h"
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

// Of a model that is sampled densely hardly any triangle is lost beside the change.
void report_lost_triangles(Job& job, const UpdateInput& input, const MeshChange& change,
                           UpdateResult& result) {
  const AstrayOptions options;
  const LostTriangles found =
      lost_triangles(input.model, result.replacement.point_of_vertex, change.triangle_map);
  job.report().set("update/staying_triangles", found.staying);
  job.report().set("update/lost_triangles", found.lost.size());
  const double least = options.min_lost_share * static_cast<double>(found.staying);
  if (found.lost.empty() || static_cast<double>(found.lost.size()) < least) return;
  const std::vector<Scan> scans = scans_of(input.clouds, result.clouds);
  const AstrayTriangles astray =
      astray_triangles(input.model, found.lost, result.mesh, scans, options);
  const double share = astray.area / found.staying_area;
  job.report().set("update/astray_area_share", share);
  if (!(share > options.min_area_share)) return;
  const bool is_coarse = std::all_of(scans.begin(), scans.end(), [&](const Scan& scan) {
    return astray.median_longest_edge > options.coarse_ratio * scan.spacing;
  });
  std::string warning =
      fmt::format("{:.0f} % of the surface of {} is not kept though nothing was scanned there",
                  100 * share, input.model_name);
  if (is_coarse) {
    warning +=
        ": it has too few vertices; make it dense first (--densify SPACING, about that of "
        "the scans)";
  } else {
    const Triangle& corners = input.model.triangles[astray.largest];
    warning += fmt::format(" ({}, as at {}); look at the result", counted(astray.count, "triangle"),
                           place_name(input.model.points[corners[0]]));
  }
  result.warnings.push_back(std::move(warning));
}

// What the session keeps of its last update.
void add_surface_of(const UpdateSession& session, UpdateResult& result) {
  result.reconstruction = session.reconstruction();
  result.mesh = session.model();
  result.replacement.points.assign(session.points().begin(), session.points().end());
}

// The program has an option for what this message advises.
std::string with_option_names(std::string message) {
  const std::string said = "say which of them goes";
  const std::size_t at = message.find(said);
  if (at != std::string::npos) message.insert(at + said.size(), " by --replace-groups");
  return message;
}

void add_overrides(JsonReport& report, const RegionOverrides& overrides) {
  const auto add = [&](const char* path, const std::vector<RegionId>& regions) {
    if (!regions.empty()) report.set(path, numbers_of(regions));
  };
  add("parameters/replace_groups", overrides.replaced);
  add("parameters/keep_groups", overrides.kept);
}

// Without a session the change is empty.
SessionUpdate update_or_throw(Job& job, const UpdateInput& input, const UpdateOptions& options,
                              UpdateSession* session) {
  try {
    if (session == nullptr) {
      return {update_model(input.model, input.clouds, options, job.execution()), {}};
    }
    SessionUpdate update = session->apply(input.clouds, options.overrides, job.execution());
    if (update.result.status == UpdateStatus::ok) add_surface_of(*session, update.result);
    return update;
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot update {}: {}", input.model_name,
                                 with_cloud_names(error.what(), input.cloud_names)));
  }
}

}  // namespace

void update_and_write(Job& job, const UpdateInput& input, const UpdateOptions& options,
                      const UpdateOutput& output, UpdateSession* session) {
  SessionUpdate update = update_or_throw(job, input, options, session);
  UpdateResult& result = update.result;
  MeshChange& change = update.change;
  report_verification(job.report(), input.model_name, result.reconstruction.verification);
  if (result.status != UpdateStatus::ok) {
    throw InputError(
        fmt::format("cannot update {} ({}): {}", input.model_name, name_of(result.status),
                    with_option_names(with_cloud_names(result.message, input.cloud_names))));
  }
  for (std::string& warning : result.warnings) {
    warning = with_cloud_names(warning, input.cloud_names);
  }
  const NoiseFilter filter = noise_filter_of_update(!input.strays.empty());
  std::vector<std::string> notes = notes_of_clouds(result, input.cloud_names, options);
  MeshReport certificate = timed(job.execution(), "check", [&] {
    if (session == nullptr) change = mesh_change(input.model, result.mesh, result.vertex_map);
    report_lost_triangles(job, input, change, result);
    return report_doubts(job, input, result, filter, output.manifold, notes);
  });
  VertexProperties properties = properties_of_update(job, input, result);
  if (output.manifold) {
    certificate = make_manifold(job, {output.mesh, session != nullptr}, result.mesh, properties);
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
