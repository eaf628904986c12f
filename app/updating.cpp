#include "app/updating.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/arguments/surface_options.h"
#include "app/files/carried_properties.h"
#include "app/files/files.h"
#include "app/report/findings.h"
#include "app/report/html_report.h"
#include "app/report/reconstruct_report.h"
#include "app/report/surface_report.h"
#include "app/report/update_report.h"
#include "app/report/verification.h"
#include "app/shapes/make_manifold.h"
#include "app/shapes/thin_cloud.h"
#include "cocone/checks/surface_doubts.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"
#include "geom/search/equal_points.h"
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

}  // namespace

UpdateOptions update_options(const SurfaceArguments& arguments) {
  UpdateOptions options = arguments.mode == Mode::paper ? paper_update_options() : UpdateOptions();
  options.cloud.reconstruct = surface_options(arguments, options.cloud.reconstruct);
  if (arguments.rho) {
    options.cloud.start.rho = *arguments.rho;
    options.cloud.finer.clear();
    options.cloud.coarser.clear();
  }
  if (arguments.alpha_deg) {
    options.cloud.start.alpha_cosine = options.cloud.reconstruct.boundary.alpha_cosine;
  }
  SurfaceArguments closed = arguments;
  closed.rho.reset();
  options.reconstruct = surface_options(closed, options.reconstruct);
  return options;
}

RegionOverrides region_overrides(const UpdateArguments& arguments) {
  RegionOverrides overrides;
  for (const std::uint32_t r : arguments.replaced_groups) overrides.replaced.emplace_back(r);
  for (const std::uint32_t r : arguments.kept_groups) overrides.kept.emplace_back(r);
  return overrides;
}

namespace {

// Points that the model leaves out are no part of what is updated: nobody else would tell.
void warn_of_unused(Job& job, const std::string& name, const ReconstructResult& model,
                    Points points) {
  MeshReport certificate;
  for (const Finding& finding : findings_of_update(model, points, NoiseFilter::no_option, {},
                                                   job.execution(), certificate)) {
    if (finding.kind == "unused") job.warn(fmt::format("{}: {}", name, finding.message));
  }
}

void add_initial_model(JsonReport& report, const ReconstructResult& model, std::size_t triangles) {
  report.set("initial_model/points", model.points);
  report.set("initial_model/duplicates", model.duplicates);
  report.set("initial_model/unused_points", model.unused_points);
  report.set("initial_model/triangles", triangles);
}

}  // namespace

ReconstructResult initial_model(Job& job, const std::string& name, const std::vector<Point>& points,
                                const KnownLabelsSource& known, const ReconstructOptions& options) {
  ReconstructResult result =
      run_step(job.execution(), "initial_model", [&](const Execution& nested) {
        return naming_input(
            name, [&] { return reconstruct_tight_with_labels(points, known, options, nested); });
      });
  require_surface(job, name, result, points, options, remedies_of_model());
  add_initial_model(job.report(), result, result.mesh.triangles.size());
  if (result.unused_points > 0) warn_of_unused(job, name, result, points);
  return result;
}

std::vector<Finding> findings_of_update(const ReconstructResult& surface, Points points,
                                        NoiseFilter filter, const OptionsLeft& left,
                                        const Execution& execution, MeshReport& certificate) {
  SurfaceDoubts doubts = surface_doubts(surface, points, {.place_handles = false}, execution);
  certificate = doubts.certificate;
  doubts.gap_samples = 0;
  doubts.unsurrounded_samples = doubts.conflicts = 0;
  return findings_of(doubts, surface.points - surface.duplicates, filter, {.noise_alone = true},
                     left);
}

NoiseFilter noise_filter_of_update(bool filtered) {
  return filtered ? NoiseFilter::no_option : NoiseFilter::of_strays;
}

bool is_model_itself(const std::vector<Point>& cloud, const TriangleMesh& model) {
  if (cloud.size() < model.points.size()) return false;
  const std::vector<Point> samples = distinct_points(cloud);
  const std::vector<Point> vertices = distinct_points(model.points.span());
  return std::includes(samples.begin(), samples.end(), vertices.begin(), vertices.end());
}

void add_filter(JsonReport& report, const CloudFilter& filter, std::size_t thinned_points) {
  add_thinning(report, filter.thin, thinned_points);
  if (filter.strays) add_cloud_filter(report, *filter.strays);
}

void add_update_parameters(JsonReport& report, const UpdateOptions& options) {
  add_parameters(report, options.cloud.reconstruct);
  add_parameters(report, options.reconstruct, "model");
}

void filter_clouds(Job& job, const CloudFilter& filter, UpdateInput& input) {
  std::size_t thinned = 0;
  for (std::size_t c = 0; c < input.clouds.size(); ++c) {
    thinned += thin_input(job, input.cloud_names[c], filter.thin, input.clouds[c],
                          input.properties.empty() ? nullptr : &input.properties[1 + c]);
  }
  add_filter(job.report(), filter, thinned);
  if (!filter.strays) return;
  for (std::size_t c = 0; c < input.clouds.size(); ++c) {
    const std::string& name = input.cloud_names[c];
    const StraySamples& strays = input.strays.emplace_back(
        leave_out_strays(name, input.clouds[c], *filter.strays, job.execution()));
    append_strays(job.report(), strays, input.clouds[c].size());
    job.say("noise: {}: {} left out", name, told_strays(strays));
    if (input.properties.empty()) continue;
    VertexProperties& properties = input.properties[1 + c];
    properties = select_properties(properties, strays.kept.raw());
  }
}

std::vector<std::string> notes_of_uneven_clouds(const UpdateResult& result,
                                                const std::vector<std::string>& names,
                                                const DensityOptions& options) {
  std::vector<std::string> notes;
  for (std::size_t c = 0; c < result.clouds.size(); ++c) {
    const CloudSurface& surface = result.clouds[c].surface;
    const SpacingRange& range = surface.spacing;
    if (!range.is_uneven(options.min_ratio)) continue;
    const char* what = surface.set_aside > 0
                           ? "few of the dense ones were looked at to find its rim"
                           : "one limit of distance does not fit both";
    notes.push_back(
        fmt::format("{}: samples are {:.2g} apart in some places and {:.2g} in others, and {}; if "
                    "something is wrong, try --thin {:.2g}",
                    names[c], range.low, range.high, what, range.high));
  }
  return notes;
}

std::string with_cloud_names(const std::string& message, const std::vector<std::string>& names) {
  std::vector<std::string> numbered;
  for (std::size_t c = 0; c < names.size(); ++c) {
    numbered.push_back(fmt::format("cloud {} of {}", c + 1, names.size()));
  }
  std::string named;
  for (std::size_t at = 0; at < message.size();) {
    // None begins with another: they end with the same words behind different numbers.
    const auto found = std::find_if(
        numbered.begin(), numbered.end(),
        [&](const std::string& cloud) { return message.compare(at, cloud.size(), cloud) == 0; });
    if (found == numbered.end()) {
      named += message[at++];
    } else {
      named += names[static_cast<std::size_t>(found - numbered.begin())];
      at += found->size();
    }
  }
  return named;
}

std::string with_option_names(std::string message) {
  const std::string said = "say which of them goes";
  const std::size_t at = message.find(said);
  if (at != std::string::npos) message.insert(at + said.size(), " by --replace-groups");
  return message;
}

void begin_session(Job& job, const std::string& name, const std::vector<Point>& points,
                   const KnownLabelsSource& known, const UpdateOptions& options,
                   std::optional<UpdateSession>& session) {
  run_step(job.execution(), "initial_model", [&](const Execution& nested) {
    naming_input(name, [&] { session.emplace(points, options, nested, known); });
  });
  require_surface(job, name, session->reconstruction(), points, options.reconstruct,
                  remedies_of_model());
  add_initial_model(job.report(), session->reconstruction(), session->model().triangles.size());
}

namespace {

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
  std::vector<std::string> notes =
      notes_of_uneven_clouds(result, input.cloud_names, options.cloud.density);
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
