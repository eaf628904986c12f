#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <memory>

#include "app/arguments/check_requirements.h"
#include "app/arguments/option_rules.h"
#include "app/arguments/option_values.h"
#include "app/arguments/thresholds.h"
#include "app/command_options.h"
#include "io/sample_models.h"

namespace cocoon::app {

namespace {

std::string in_one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

const std::string rho_of_clouds =
    "here for the rims of clouds; by default 0.3 and, where that finds no good rim, others, each "
    "with its own --alpha";

void add_stages_of_reconstruct(CLI::App& app, ReconstructArguments& arguments) {
  app.add_flag("--cavities", arguments.cavities,
               "Keep closed surfaces inside the body: they bound hollows of it");
  const std::string stages = "Single stages (with their defaults; not with --session)";
  add_radius(app, arguments.radius, stages);
  add_switch_off(
      app, "--no-deferred-seeding", arguments.deferred_seeding,
      "Peel what no mark has reached, as published, instead of marking it from its widest opening")
      ->group(stages);
  add_switch_off(app, "--no-second-look", arguments.second_look,
                 "Take the first surface, also where samples contradict each other about what is "
                 "inside; so does --radius")
      ->group(stages);
  add_switch_off(app, "--no-clean-up", arguments.clean_up, "Leave the surface as the peel left it")
      ->group(stages);
  for (const ThresholdUse use : {ThresholdUse::cocone, ThresholdUse::tight,
                                 ThresholdUse::second_look, ThresholdUse::clean_up}) {
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

void add_stages_of_boundary(CLI::App& app, BoundaryArguments& arguments) {
  const std::string stages = "Single stages (with their defaults)";
  add_radius(app, arguments.radius, stages);
  for (const ThresholdUse use : {ThresholdUse::cocone, ThresholdUse::loops}) {
    add_thresholds_of(app, use, arguments.thresholds, stages);
  }
}

// A command under construction: its arguments live here until CLI11 has filled them in.
template <class Arguments>
Arguments& add_command(CLI::App& app, const std::string& description, Command& chosen,
                       SharedArguments& shared, CLI::App*& subcommand) {
  auto arguments = std::make_shared<Arguments>();
  subcommand = app.add_subcommand(Arguments::command, description);
  add_shared_options(*subcommand, shared);
  subcommand->final_callback([arguments, &chosen] { chosen = *arguments; });
  return *arguments;
}

void add_demo_and_sample(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& demo = add_command<DemoArguments>(
      app, "Update the built-in test block with its U-shaped cloud", chosen, shared, sub);
  sub->add_option("-o,--output", demo.folder, "Folder to write to (demo-output)")
      ->type_name("DIR")
      ->check(folder_name());

  auto& sample = add_command<SampleArguments>(app, "Write one of the paper's models as points",
                                              chosen, shared, sub);
  sub->add_option("NAME", sample.name, "Model")
      ->required()
      ->check(CLI::IsMember(sample_model_names()));
  sub->add_option("-o,--output", sample.folder, "Folder to write to (the model's name)")
      ->type_name("DIR")
      ->check(folder_name());
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

const std::string keeps_properties = "; PLY also keeps the vertices' properties";

void add_reconstruct_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& reconstruct =
      add_command<ReconstructArguments>(app, "Point cloud to mesh", chosen, shared, sub);
  sub->add_option("POINTS", reconstruct.points, "Point cloud")->required();
  add_mesh_output(*sub, reconstruct.mesh, reconstruct.writing, keeps_properties);
  add_densify(*sub, "POINTS", reconstruct.densify);
  add_thin(*sub, reconstruct.thin, "");
  add_choice<SurfaceKind>(*sub, "--surface", reconstruct.surface,
                          "tight: watertight (default); cocone: the open surface",
                          {{"tight", SurfaceKind::tight}, {"cocone", SurfaceKind::cocone}});
  add_manifold_option(*sub, reconstruct.manifold);
  add_trim(
      *sub, reconstruct.trim,
      "Open the watertight surface where nothing was scanned: leave out triangles with an edge "
      "longer than so many local spacings (8 suits most open scans)");
  sub->add_option(
         "--session", reconstruct.session,
         "Also write a session, from which 'update --session' goes on without this work; not "
         "with --noise robust or --trim")
      ->type_name("FILE");
  add_noise(
      *sub, reconstruct.noise,
      "robust: leave out clumps of stray points, outliers and what lies inside a layer of "
      "noise first (Robust Cocone; tight surfaces only); none (default): every sample counts");
  add_surface_options(*sub, reconstruct.parameters, "1 / 1.2 if --surface is tight, else 0.3");
  add_stages_of_reconstruct(*sub, reconstruct);
}

void add_boundary_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& boundary = add_command<BoundaryArguments>(
      app, "The surface of an open cloud and its boundary loops", chosen, shared, sub);
  sub->add_option("POINTS", boundary.points, "Point cloud")->required();
  add_mesh_output(*sub, boundary.mesh, boundary.writing, keeps_properties);
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

void add_groups(CLI::App& app, const std::string& name, std::vector<std::uint32_t>& groups,
                const std::string& meaning) {
  app.add_option(name, groups, meaning)
      ->delimiter(',')
      ->type_name("N,...")
      ->allow_extra_args(false)
      ->transform(without_leading_zeros())
      ->check(CLI::Range(0, std::numeric_limits<std::int32_t>::max()));
}

void add_keep_crowded(CLI::App& app, bool& keep_crowded) {
  app.add_flag("--keep-crowded", keep_crowded,
               "Keep all samples where new scans lie in layers, out of register, even if the "
               "surface has fewer handles or parts without those that crowd");
}

void add_update_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& update = add_command<UpdateArguments>(
      app, "Replace the parts of a mesh that new clouds show changed", chosen, shared, sub);
  sub->add_option("MODEL", update.model,
                  "Mesh, or a point cloud that is reconstructed first; with --session, a cloud")
      ->required();
  sub->add_option("CLOUD", update.clouds, "New scans, registered to the model");
  sub->add_option("--session", update.session,
                  "Go on from this session instead of a MODEL, and write it back; its parameters "
                  "hold, but for --rho and --keep-crowded")
      ->type_name("FILE");
  add_mesh_output(*sub, update.mesh, update.writing, keeps_properties + " (but for --session)");
  add_densify(*sub, "MODEL", update.densify);
  add_keep_coarse(*sub, update.keep_coarse);
  sub->add_option("--map", update.map,
                  "Write one line per vertex or point of MODEL: its new index, or -1; not for STL, "
                  "which keeps no numbers of vertices; - = standard output")
      ->type_name("FILE");
  sub->add_option("--html", update.html,
                  "Write a report that a browser opens offline; - = standard output")
      ->type_name("FILE");
  add_manifold_option(*sub, update.manifold);
  add_groups(*sub, "--replace-groups", update.replaced_groups,
             "Replace these groups of the model, whatever the angles say: the numbers are those "
             "that the same update without it tells");
  add_groups(*sub, "--keep-groups", update.kept_groups, "Keep these groups of the model, likewise");
  add_surface_options(*sub, update.parameters, rho_of_clouds);
  add_keep_crowded(*sub, update.parameters.keep_crowded);
  add_cloud_filter(*sub, update.filter);
}

void add_watch_command(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& watch = add_command<WatchArguments>(
      app, "Update a model by every cloud that appears in a folder", chosen, shared, sub);
  sub->add_option("MODEL", watch.model, "Mesh, or a point cloud that is reconstructed first")
      ->required();
  sub->add_option("DIR", watch.folder,
                  "Folder into which scanners drop their clouds; MODEL and what is written are no "
                  "clouds if they lie there")
      ->required();
  add_mesh_output(*sub, watch.mesh, watch.writing);
  add_densify(*sub, "MODEL", watch.densify);
  add_keep_coarse(*sub, watch.keep_coarse);
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
  add_keep_crowded(*sub, watch.parameters.keep_crowded);
  add_cloud_filter(*sub, watch.filter);
}

// As --json has it; outputs whose name tells their format have no use for that.
void settle_standard_output(UpdateArguments& update) {
  for (std::string* file : {&update.map, &update.html}) {
    if (*file == "-") *file = "/dev/stdout";
  }
}

// Of the positional arguments the first is the model, unless a session has it. `command`: update.
void settle_model(const CLI::App& command, UpdateArguments& update) {
  if (!update.session.empty()) {
    if (update.densify) {
      throw UsageError(
          "a session has a dense model already: with --session leave out --densify, or give it to "
          "the reconstruct that begins the session");
    }
    if (update.keep_coarse) {
      throw UsageError(
          "a session takes its model as it is: with --session leave out --keep-coarse");
    }
    update.clouds.insert(update.clouds.begin(), std::move(update.model));
    update.model.clear();
    const auto is_given = [&](const char* name) { return command.count(name) > 0; };
    constexpr std::array own = {"--alpha", "--cocone-angle", "--sharp-angle", "--mode"};
    if (std::any_of(own.begin(), own.end(), is_given)) {
      throw UsageError(
          "a session has the parameters that its surface was made with: leave out --alpha, "
          "--cocone-angle, --sharp-angle and --mode, or give them to the reconstruct that begins "
          "the session");
    }
  } else if (update.clouds.empty()) {
    throw UsageError("CLOUD is required (see cocoon update --help)");
  }
}

void add_other_commands(CLI::App& app, Command& chosen, SharedArguments& shared) {
  CLI::App* sub = nullptr;
  auto& delaunay = add_command<DelaunayArguments>(app, "The 3D Delaunay triangulation of points",
                                                  chosen, shared, sub);
  sub->add_option("POINTS", delaunay.points, "Point cloud")->required();
  sub->add_option("-o,--output", delaunay.file, "The file to write: .vtu, .mesh or .tet")
      ->required()
      ->type_name("FILE");
  add_ascii(*sub, delaunay.ascii);
  add_verify(*sub, delaunay.verify);

  auto& check = add_command<CheckArguments>(app, "A certificate of a mesh", chosen, shared, sub);
  sub->add_option("MESH", check.mesh, "Mesh")->required();
  sub->add_option("--require", check.required,
                  "Exit with 1 unless all hold: " + requirement_words() +
                      " (closed, watertight: no edge with an odd number of triangles; manifold: "
                      "edge- and vertex-manifold)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(without_blanks())
      ->type_name("WORD,...");
  sub->add_flag("--self-intersections", check.self_intersections,
                "Also look for triangles that cross");
  sub->add_option("--handles", check.handles,
                  "Also tell where so many of the narrowest handles are")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{0}, std::size_t{1000000}))
      ->type_name("COUNT");

  auto& compare = add_command<CompareArguments>(app, "Distances between two surfaces or clouds",
                                                chosen, shared, sub);
  sub->add_option("A", compare.a, "Mesh or point cloud")->required();
  sub->add_option("B", compare.b, "Mesh or point cloud")->required();
  sub->add_option("--samples", compare.samples,
                  "Sample points on each mesh (100000); all are kept in memory, 24 bytes each")
      ->transform(without_leading_zeros())
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000000}));
  sub->add_option("--tolerance", compare.tolerance,
                  "Also tell which share of either surface is at most so far from the other")
      ->check(between(0, 1e300))
      ->type_name("DISTANCE");
  sub->add_option("-o,--output", compare.mesh,
                  "Write A with the distances of its vertices from B, as property and as colors "
                  "(full at --tolerance, or at three times the RMS of its vertices): .ply")
      ->type_name("MESH");
  add_writing(*sub, compare.writing);
}

// The first argument that is no option before the command, nor the value of one.
std::string first_word(const CLI::App& app, int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.empty() || argument.front() != '-') return argument;
    const std::size_t equals = argument.find('=');
    const CLI::Option* option = app.get_option_no_throw(argument.substr(0, equals));
    if (option == nullptr) return {};  // an error that others name
    if (equals == std::string::npos && option->get_items_expected_max() > 0) ++i;
  }
  return {};
}

// CLI11 alone would answer to a misspelled command that one is missing.
void require_known_command(const CLI::App& app, int argc, const char* const* argv) {
  const std::string first = first_word(app, argc, argv);
  if (first.empty()) return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == first) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw UsageError(fmt::format("'{}' is no command; there are {}", first, names));
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
  const bool is_of_session = app.get_subcommand(UpdateArguments::command)->count("--session") > 0;
  if (is_of_session && problem == "MODEL is required") problem = "CLOUD is required";
  const std::string of_repeated = "At Most 1 required but received ";
  if (const std::size_t at = problem.find(of_repeated); at != std::string::npos) {
    const std::string times = problem.substr(at + of_repeated.size());
    problem = problem.substr(0, at) + fmt::format("is given {} times; give it once", times);
  }
  std::string command;
  for (const CLI::App* chosen : app.get_subcommands()) command = chosen->get_name() + " ";
  if (const auto extras = app.remaining(true); !extras.empty()) {
    problem = in_one_line(unexpected_told("cocoon " + command, extras));
  }
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
    if (auto* update = std::get_if<UpdateArguments>(&line.command)) {
      settle_model(*app.get_subcommand(UpdateArguments::command), *update);
      settle_standard_output(*update);
    }
    require_possible_options(line.command);
  } catch (const CLI::CallForVersion& version) {
    return TextRequest{std::string(version.what()) + "\n"};
  } catch (const CLI::Success&) {    // --help
    return TextRequest{app.help()};  // of the chosen command, if there is one
  } catch (const CLI::ParseError& error) {
    // CLI11 says of an empty value that it is not in some range.
    for (const CLI::App* command : app.get_subcommands()) require_no_empty_values(*command);
    throw UsageError(problem_told(app, error));
  }
  return line;
}

}  // namespace cocoon::app
