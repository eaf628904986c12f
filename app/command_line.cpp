#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <memory>

#include "app/check_requirements.h"
#include "app/cloud_filter.h"
#include "app/option_values.h"
#include "app/surface_options.h"
#include "app/thresholds.h"
#include "io/number_text.h"
#include "io/sample_models.h"

namespace cocoon::app {

namespace {

std::string in_one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void add_shared_options(CLI::App& app, SharedArguments& shared) {
  app.add_option("--threads", shared.threads, "Number of threads; 0 = all cores (default)")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(0, 1024));
  app.add_option("--json", shared.json, "Write the JSON report to FILE; - = standard output")
      ->type_name("FILE");
  app.add_flag("--quiet", shared.quiet, "Print no summary");
  app.add_flag("--verbose", shared.verbose, "Print the time of every stage");
  app.add_flag("--progress", shared.progress, "Show progress even if stderr is no terminal");
  app.add_flag("--skip-non-finite", shared.skip_non_finite,
               "Leave out points with nan or inf, and count them, instead of refusing the file");
  app.set_version_flag("--version", std::string("cocoon ") + COCOON_VERSION);
}

void add_verify(CLI::App& app, bool& verify) {
  app.add_flag("--verify", verify,
               "Check the result exactly before it is written, and write nothing if that fails");
}

const std::string rho_of_clouds =
    "here for the rims of clouds; by default 0.3 and, where that finds no good rim, others, each "
    "with its own --alpha";

// "(30)", as the help shows defaults.
std::string in_parentheses(double value) { return fmt::format(" ({:.6g})", value); }

// `of_rho`: what else there is to be said of it.
void add_surface_options(CLI::App& app, SurfaceArguments& parameters, const std::string& of_rho) {
  const ReconstructOptions defaults;
  app.add_option("-r,--rho", parameters.rho,
                 "Ratio condition: a sample is well sampled only if the radius of its cocone is at "
                 "most RHO times its height, the distance to its negative pole; " +
                     of_rho)
      ->check(between(1e-6, 1))
      ->type_name("RHO");
  app.add_option("-f,--alpha", parameters.alpha_deg,
                 "Normal condition: largest angle between the normals of cocone neighbors" +
                     in_parentheses(told_in_degrees(std::acos(defaults.boundary.alpha_cosine))))
      ->check(between(0, 90))
      ->type_name("DEGREES");
  app.add_option("-c,--cocone-angle", parameters.cocone_angle_deg,
                 "Half opening of the cocone about the tangent plane" +
                     in_parentheses(told_in_degrees(std::asin(defaults.cocone.cosine))))
      ->check(between(0.1, 89.9))
      ->type_name("DEGREES");
  app.add_option("-s,--sharp-angle", parameters.sharp_angle_deg,
                 "Dihedral angle below which a surface edge is sharp and its triangles are pruned" +
                     in_parentheses(told_in_degrees(std::acos(defaults.prune.sharp_cosine))))
      ->check(between(0, 180))
      ->type_name("DEGREES");
  app.add_option("--mode", parameters.mode,
                 "paper: the published reconstruction alone, and in updates the published way to "
                 "locate a rim on the model, no long edges trimmed, no samples set aside; robust "
                 "(default): with our repairs, each counted in the report")
      ->check(CLI::IsMember({"paper", "robust"}));
  add_verify(app, parameters.verify);
}

// Of what is on by default: CLI11's own negative flags ("!--no-...") stand with "{false}" in
// --help.
CLI::Option* add_switch_off(CLI::App& app, const std::string& name, bool& is_on,
                            const std::string& meaning) {
  return app.add_flag_callback(
      name, [&is_on] { is_on = false; }, meaning);
}

// `of_ply`: what else there is to be said of that format.
CLI::Option* add_mesh_output(CLI::App& app, std::string& mesh, bool& ascii,
                             const std::string& of_ply = "") {
  app.add_flag("--ascii", ascii, "Write text where the format has a binary and a text form");
  return app
      .add_option("-o,--output", mesh, "The mesh to write: .ply, .obj, .off or .stl" + of_ply)
      ->required()
      ->type_name("MESH");
}

void add_manifold_option(CLI::App& app, bool& manifold) {
  app.add_flag(
      "--manifold", manifold,
      "Split edges with more than two triangles and pinched vertices: the sheets that meet "
      "there get vertices of their own");
}

void add_radius(CLI::App& app, std::string& radius, const std::string& group) {
  app.add_option("--radius", radius,
                 "Ratio condition: what is measured of a sample's cell, its cocone (of open clouds "
                 "the default) or its tangent plane (of closed surfaces; not in paper mode)")
      ->check(CLI::IsMember({"cocone", "tangent-plane"}))
      ->group(group);
}

void add_thresholds_of(CLI::App& app, ThresholdUse use, std::map<std::string, double>& given,
                       const std::string& group, const StageOptions& defaults = {}) {
  for (const Threshold& t : thresholds()) {
    if (t.use != use) continue;
    const bool whole = t.kind == ThresholdKind::whole;
    CLI::Option* option = app.add_option_function<double>(
        std::string("--") + t.name, [&given, &t](double value) { given[t.name] = value; },
        t.meaning + in_parentheses(told_value(t, defaults)));
    if (whole) option->check(CLI::TypeValidator<std::uint64_t>("WHOLE NUMBER"));
    option->check(between(t.low, t.high))
        ->type_name(t.kind == ThresholdKind::angle ? "DEGREES"
                    : whole                        ? "COUNT"
                                                   : "NUMBER")
        ->group(group);
  }
}

void add_stages_of_reconstruct(CLI::App& app, ReconstructArguments& arguments) {
  app.add_flag("--cavities", arguments.cavities,
               "Keep closed surfaces inside the body: they bound hollows of it");
  const std::string stages = "Single stages (with their defaults; not with --session)";
  add_radius(app, arguments.radius, stages);
  add_switch_off(
      app, "--no-deferred-seeding", arguments.deferred_seeding,
      "Peel what no mark has reached, as published, instead of marking it from its widest opening")
      ->group(stages);
  add_switch_off(app, "--no-clean-up", arguments.clean_up, "Leave the surface as the peel left it")
      ->group(stages);
  for (const ThresholdUse use :
       {ThresholdUse::cocone, ThresholdUse::tight, ThresholdUse::clean_up}) {
    add_thresholds_of(app, use, arguments.thresholds, stages);
  }
  const std::string noise = "Noise filter (with --noise robust)";
  add_switch_off(app, "--noise-skin-only", arguments.noise_keep_good,
                 "Leave out all samples off the outer skin, as published: good ones, too")
      ->group(noise);
  add_switch_off(app, "--noise-spacing-only", arguments.noise_spare_good,
                 "Tell outliers by their spacing alone, also where the surface of all samples "
                 "surrounds them")
      ->group(noise);
  for (const ThresholdUse use : {ThresholdUse::outliers, ThresholdUse::noise}) {
    add_thresholds_of(app, use, arguments.thresholds, noise);
  }
  add_thresholds_of(app, ThresholdUse::findings, arguments.thresholds, "Findings");
}

void add_thin(CLI::App& app, std::optional<double>& distance, const std::string& of_what) {
  app.add_option("--thin", distance,
                 "Leave out points" + of_what +
                     " closer than this to one that is used: of scans that are denser than their "
                     "noise, or overlap")
      ->type_name("DISTANCE")
      ->check(between(1e-300, 1e300));
}

void add_cloud_filter(CLI::App& app, CloudFilterArguments& arguments) {
  add_thin(app, arguments.thin, " of each new scan");
  app.add_option("--noise", arguments.noise,
                 "robust: leave stray points and small clumps of them out of each new scan first; "
                 "none (default): every sample counts")
      ->check(CLI::IsMember({"none", "robust"}));
  add_thresholds_of(app, ThresholdUse::outliers, arguments.thresholds,
                    "Noise filter (with --noise robust)", cloud_filter_defaults());
}

void add_stages_of_boundary(CLI::App& app, BoundaryArguments& arguments) {
  const std::string stages = "Single stages (with their defaults)";
  add_radius(app, arguments.radius, stages);
  for (const ThresholdUse use : {ThresholdUse::cocone, ThresholdUse::loops}) {
    add_thresholds_of(app, use, arguments.thresholds, stages);
  }
}

// A command under construction: its arguments live here until CLI11 has filled them in.
template <class Arguments>
Arguments& add_command(CLI::App& app, const std::string& name, const std::string& description,
                       Command& chosen, SharedArguments& shared, CLI::App*& subcommand) {
  auto arguments = std::make_shared<Arguments>();
  subcommand = app.add_subcommand(name, description);
  add_shared_options(*subcommand, shared);
  subcommand->final_callback([arguments, &chosen] { chosen = *arguments; });
  return *arguments;
}

void add_demo_and_sample(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& demo = add_command<DemoArguments>(
      app, "demo", "Update the built-in test block with its U-shaped cloud", chosen, shared, sub);
  sub->add_option("-o,--output", demo.folder, "Folder to write to (demo-output)")->type_name("DIR");

  auto& sample = add_command<SampleArguments>(
      app, "sample", "Write one of the paper's models as points", chosen, shared, sub);
  sub->add_option("NAME", sample.name, "Model")
      ->required()
      ->check(CLI::IsMember(sample_model_names()));
  sub->add_option("-o,--output", sample.folder, "Folder to write to (the model's name)")
      ->type_name("DIR");
  sub->add_option("--points", sample.points, "Points of the initial model (the paper's number)")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{4}, most_sample_points));
  sub->add_option("--cloud-points", sample.cloud_points,
                  "Points of all clouds together (the paper's number)")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{4}, most_sample_points));
  sub->add_option("--seed", sample.seed, "Seed of the random placement (1)")
      ->transform(without_leading_zeros())
      ->check(whole_number())
      ->type_name("N");
}

void add_densify(CLI::App& sub, const std::string& mesh, std::optional<double>& spacing) {
  sub.add_option("--densify", spacing,
                 mesh +
                     " is a mesh with large triangles (CAD): add samples on them, about so far "
                     "apart, so that its surface can be updated")
      ->type_name("SPACING")
      ->check(between(1e-300, 1e300));
}

void add_trim(CLI::App& sub, std::optional<double>& max_edge, const std::string& what_for) {
  sub.add_option("--trim", max_edge, what_for)->type_name("TIMES")->check(between(1, 1e300));
}

const std::string keeps_properties = "; PLY also keeps the vertices' properties";

void add_reconstruct_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& reconstruct = add_command<ReconstructArguments>(app, "reconstruct", "Point cloud to mesh",
                                                        chosen, shared, sub);
  sub->add_option("POINTS", reconstruct.points, "Point cloud")->required();
  add_mesh_output(*sub, reconstruct.mesh, reconstruct.ascii,
                  keeps_properties + " (but for --densify)");
  add_densify(*sub, "POINTS", reconstruct.densify);
  add_thin(*sub, reconstruct.thin, "");
  sub->add_option("--surface", reconstruct.surface,
                  "tight: watertight (default); cocone: the open surface")
      ->check(CLI::IsMember({"tight", "cocone"}));
  add_manifold_option(*sub, reconstruct.manifold);
  add_trim(
      *sub, reconstruct.trim,
      "Open the watertight surface where nothing was scanned: leave out triangles with an edge "
      "longer than so many local spacings (8 suits most open scans)");
  sub->add_option("--session", reconstruct.session,
                  "Also write a session, from which 'update --session' goes on without this work")
      ->type_name("FILE");
  sub->add_option(
         "--noise", reconstruct.noise,
         "robust: leave out clumps of stray points, outliers and what lies inside a layer of "
         "noise first (Robust Cocone; tight surfaces only); none (default): every sample counts")
      ->check(CLI::IsMember({"none", "robust"}));
  add_surface_options(*sub, reconstruct.parameters, "1 / 1.2 if --surface is tight, else 0.3");
  add_stages_of_reconstruct(*sub, reconstruct);
}

void add_boundary_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& boundary = add_command<BoundaryArguments>(
      app, "boundary", "The surface of an open cloud and its boundary loops", chosen, shared, sub);
  sub->add_option("POINTS", boundary.points, "Point cloud")->required();
  add_mesh_output(*sub, boundary.mesh, boundary.ascii, keeps_properties);
  sub->add_option("--loops", boundary.loops, "Write the boundary loops as polylines")
      ->type_name("FILE.obj");
  sub->add_flag("--label-samples", boundary.label_samples,
                "Also write which vertices are boundary samples, as property boundary_sample");
  add_thin(*sub, boundary.thin, "");
  add_trim(*sub, boundary.trim,
           "Leave out triangles with an edge longer than so many local spacings, with which the "
           "surface bridges slots and holes (update takes 5)");
  add_surface_options(*sub, boundary.parameters, "0.3 by default");
  add_stages_of_boundary(*sub, boundary);
}

void add_update_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& update = add_command<UpdateArguments>(
      app, "update", "Replace the parts of a mesh that new clouds show changed", chosen, shared,
      sub);
  sub->add_option("MODEL", update.model,
                  "Mesh, or a point cloud that is reconstructed first; with --session, a cloud")
      ->required();
  sub->add_option("CLOUD", update.clouds, "New scans, registered to the model");
  sub->add_option("--session", update.session,
                  "Go on from this session instead of a MODEL, and write it back; its parameters "
                  "hold, but for --rho")
      ->type_name("FILE");
  add_mesh_output(*sub, update.mesh, update.ascii,
                  keeps_properties + " (but for --session and, of MODEL, --densify)");
  add_densify(*sub, "MODEL", update.densify);
  sub->add_option("--map", update.map,
                  "Write one line per vertex or point of MODEL: its new index, or -1; not for STL, "
                  "which keeps no numbers of vertices")
      ->type_name("FILE");
  sub->add_option("--html", update.html, "Write a report that a browser opens offline")
      ->type_name("FILE");
  add_manifold_option(*sub, update.manifold);
  add_surface_options(*sub, update.parameters, rho_of_clouds);
  add_cloud_filter(*sub, update.filter);
}

void add_watch_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& watch = add_command<WatchArguments>(
      app, "watch", "Update a model by every cloud that appears in a folder", chosen, shared, sub);
  sub->add_option("MODEL", watch.model, "Mesh, or a point cloud that is reconstructed first")
      ->required();
  sub->add_option("DIR", watch.folder,
                  "Folder into which scanners drop their clouds; MODEL and what is written are no "
                  "clouds if they lie there")
      ->required();
  add_mesh_output(*sub, watch.mesh, watch.ascii);
  add_densify(*sub, "MODEL", watch.densify);
  sub->add_option("--session", watch.session,
                  "Where the state is kept, to resume from after any end (MESH.session)")
      ->type_name("FILE");
  sub->add_option("--poll", watch.poll, "Seconds between two looks into the folder (0.5)")
      ->check(between(0.01, 3600));
  sub->add_option("--settle", watch.settle,
                  "Seconds that a file must have stayed the same to count as complete (1)")
      ->check(between(0, 3600));
  sub->add_option("--save-every", watch.save_every,
                  "Clouds until the whole session is written again; till then each is kept in a "
                  "small file beside it (32)")
      ->type_name("N")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
  sub->add_flag("--together", watch.together,
                "Take files that come together, each before those before it have settled, as views "
                "of one change: they are applied in one update");
  sub->add_flag("--once", watch.once, "Stop when all clouds that are there have been looked at");
  add_surface_options(*sub, watch.parameters, rho_of_clouds);
  add_cloud_filter(*sub, watch.filter);
}

// Of the positional arguments the first is the model, unless a session has it.
void settle_model(UpdateArguments& update) {
  if (!update.session.empty()) {
    if (update.densify) {
      throw UsageError(
          "a session has a dense model already: with --session leave out --densify, or give it to "
          "the reconstruct that begins the session");
    }
    update.clouds.insert(update.clouds.begin(), std::move(update.model));
    update.model.clear();
    const SurfaceArguments& given = update.parameters;
    if (given.alpha_deg || given.cocone_angle_deg || given.sharp_angle_deg ||
        given.mode != SurfaceArguments().mode) {
      throw UsageError(
          "a session has parameters of its own: with --session only --rho may be given");
    }
  } else if (update.clouds.empty()) {
    throw UsageError("CLOUD is required (see cocoon update --help)");
  }
}

void add_other_commands(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& delaunay = add_command<DelaunayArguments>(
      app, "delaunay", "The 3D Delaunay triangulation of points", chosen, shared, sub);
  sub->add_option("POINTS", delaunay.points, "Point cloud")->required();
  sub->add_option("-o,--output", delaunay.file, "The file to write: .vtu, .mesh or .tet")
      ->required()
      ->type_name("FILE");
  add_verify(*sub, delaunay.verify);

  auto& check =
      add_command<CheckArguments>(app, "check", "A certificate of a mesh", chosen, shared, sub);
  sub->add_option("MESH", check.mesh, "Mesh")->required();
  sub->add_option("--require", check.required,
                  "Exit with 1 unless all hold: " + requirement_words() +
                      " (closed, watertight: no edge with an odd number of triangles; manifold: "
                      "edge- and vertex-manifold)")
      ->delimiter(',')
      ->type_name("WORD,...");
  sub->add_flag("--self-intersections", check.self_intersections,
                "Also look for triangles that cross");
  sub->add_option("--handles", check.handles,
                  "Also tell where so many of the narrowest handles are")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{0}, std::size_t{1000000}))
      ->type_name("COUNT");

  auto& compare = add_command<CompareArguments>(
      app, "compare", "Distances between two surfaces or clouds", chosen, shared, sub);
  sub->add_option("A", compare.a, "Mesh or point cloud")->required();
  sub->add_option("B", compare.b, "Mesh or point cloud")->required();
  sub->add_option("--samples", compare.samples, "Sample points on each mesh (100000)")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
}

// CLI11 alone would answer to a misspelled command that one is missing.
void require_known_command(const CLI::App& app, int argc, const char* const* argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  if (first.empty() || first.front() == '-') return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == first) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw UsageError(fmt::format("'{}' is no command; there are {}", first, names));
}

// As a shell makes them of variables that are not set. Taken for an option that is not given, an
// output would be missing in the end.
void require_no_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (!value.empty()) continue;
      throw UsageError(option->get_name() + ": the value is empty; give one");
    }
  }
}

// The options that may be given before the command, too: of two places one would be ignored.
void require_in_one_place(const CLI::App& app, const CLI::App& command) {
  for (const char* name : {"--json", "--threads"}) {
    if (app.count(name) > 0 && command.count(name) > 0) {
      throw UsageError(fmt::format("{} is given before {} and behind it; leave out one", name,
                                   command.get_name()));
    }
  }
}

std::string problem_told(const CLI::App& app, const CLI::ParseError& error) {
  std::string problem = in_one_line(error.what());
  // With a session the first of the arguments without a name is a cloud (settle_model).
  const bool is_of_session = app.get_subcommand("update")->count("--session") > 0;
  if (is_of_session && problem == "MODEL is required") problem = "CLOUD is required";
  std::string command;
  for (const CLI::App* chosen : app.get_subcommands()) command = chosen->get_name() + " ";
  return fmt::format("{} (see cocoon {}--help)", problem, command);
}

}  // namespace

Request parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  CLI::App app(
      "Cocoon turns 3D point clouds into triangle meshes and updates a mesh from new scans");
  app.name("cocoon");
  app.require_subcommand(1);
  add_shared_options(app, line.shared);
  add_demo_and_sample(app, line.command, line.shared);
  add_reconstruct_command(app, line.command, line.shared);
  add_boundary_command(app, line.command, line.shared);
  add_update_command(app, line.command, line.shared);
  add_watch_command(app, line.command, line.shared);
  add_other_commands(app, line.command, line.shared);
  app.footer("Options of a command: cocoon COMMAND --help");  // commands would take it over
  try {
    require_known_command(app, argc, argv);
    app.parse(argc, argv);
    require_no_empty_values(app);
    for (const CLI::App* command : app.get_subcommands()) {
      require_no_empty_values(*command);
      require_in_one_place(app, *command);
    }
    if (const auto* check = std::get_if<CheckArguments>(&line.command)) {
      require_known_words(check->required);
    }
    if (auto* update = std::get_if<UpdateArguments>(&line.command)) settle_model(*update);
    if (const auto* reconstruct = std::get_if<ReconstructArguments>(&line.command);
        reconstruct != nullptr && !reconstruct->session.empty() &&
        reconstruct->surface != "tight") {
      throw UsageError("--session needs the watertight surface: leave out --surface cocone");
    }
  } catch (const CLI::CallForVersion& version) {
    return TextRequest{std::string(version.what()) + "\n"};
  } catch (const CLI::Success&) {    // --help
    return TextRequest{app.help()};  // of the chosen command, if there is one
  } catch (const CLI::ParseError& error) {
    throw UsageError(problem_told(app, error));
  }
  return line;
}

}  // namespace cocoon::app
