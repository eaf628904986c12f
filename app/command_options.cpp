#include "app/command_options.h"

#include <cmath>
#include <cstdint>
#include <fmt/format.h>

#include "app/arguments/option_values.h"
#include "app/arguments/surface_options.h"
#include "app/shapes/cloud_filter.h"

namespace cocoon::app {

namespace {

// "(30)", as the help shows defaults.
std::string in_parentheses(double value) { return fmt::format(" ({:.6g})", value); }

}  // namespace

void add_shared_options(CLI::App& app, SharedArguments& shared) {
  app.add_option("--threads", shared.threads,
                 "Number of threads; 0 = all cores it may use (default)")
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
  app.add_flag(
      "--verify", verify,
      "Check triangulation and surface exactly, before --trim, --manifold or --float change "
      "what is written; write nothing if that fails");
}

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
  add_choice<Mode>(
      app, "--mode", parameters.mode,
      "paper: the published reconstruction alone, and in updates the published way to "
      "locate a rim on the model, no long edges trimmed, no samples set aside or left out; robust "
      "(default): with our repairs, each counted in the report",
      {{name_of(Mode::paper), Mode::paper}, {name_of(Mode::robust), Mode::robust}});
  add_verify(app, parameters.verify);
}

CLI::Option* add_switch_off(CLI::App& app, const std::string& name, bool& is_on,
                            const std::string& meaning) {
  return app.add_flag_callback(
      name, [&is_on] { is_on = false; }, meaning);
}

void add_ascii(CLI::App& app, bool& ascii) {
  app.add_flag("--ascii", ascii, "Write text where the format has a binary and a text form");
}

void add_writing(CLI::App& app, MeshWriteOptions& writing) {
  add_ascii(app, writing.ascii);
  app.add_flag("--float", writing.single_precision,
               "PLY: round coordinates to float, for programs that read no double");
}

CLI::Option* add_mesh_output(CLI::App& app, std::string& mesh, MeshWriteOptions& writing,
                             const std::string& of_ply) {
  add_writing(app, writing);
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

void add_radius(CLI::App& app, std::optional<RadiusMode>& radius, const std::string& group) {
  std::vector<std::pair<std::string, RadiusMode>> choices;
  for (const RadiusMode mode : {RadiusMode::cocone, RadiusMode::tangent_plane}) {
    choices.emplace_back(name_of(mode), mode);
  }
  add_choice<RadiusMode>(
      app, "--radius", radius,
      "Ratio condition: what is measured of a sample's cell, its cocone (of open clouds "
      "the default) or its tangent plane (of closed surfaces; not in paper mode)",
      choices)
      ->group(group);
}

void add_noise(CLI::App& app, NoiseHandling& noise, const std::string& meaning) {
  add_choice<NoiseHandling>(app, "--noise", noise, meaning,
                            {{"none", NoiseHandling::none}, {"robust", NoiseHandling::robust}});
}

void add_thresholds_of(CLI::App& app, ThresholdUse use, std::map<std::string, double>& given,
                       const std::string& group, const StageOptions& defaults) {
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
  add_noise(app, arguments.noise,
            "robust: leave stray points and small clumps of them out of each new scan first; "
            "none (default): every sample counts");
  add_thresholds_of(app, ThresholdUse::outliers, arguments.thresholds,
                    "Noise filter (with --noise robust)", cloud_filter_defaults());
}

void add_densify(CLI::App& app, const std::string& mesh, std::optional<double>& spacing) {
  app.add_option("--densify", spacing,
                 mesh +
                     " is a mesh with large triangles (CAD): add samples on them, about so far "
                     "apart, so that its surface can be updated")
      ->type_name("SPACING")
      ->check(between(1e-300, 1e300));
}

void add_keep_coarse(CLI::App& app, bool& keeps) {
  app.add_flag(
      "--keep-coarse", keeps,
      "Take the vertices of a mesh with large triangles alone, even if its surface is lost "
      "so; otherwise samples are added as by --densify where that keeps it");
}

void add_trim(CLI::App& app, std::optional<double>& max_edge, const std::string& what_for) {
  app.add_option("--trim", max_edge, what_for)->type_name("TIMES")->check(between(1, 1e300));
}

}  // namespace cocoon::app
