// Options that several commands have. Each function adds one, or some that belong together.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>

#include "app/arguments/thresholds.h"
#include "app/command_line.h"
#include "io/mesh_file_options.h"

namespace cocoon::app {

// Those that all commands have, and the program itself.
void add_shared_options(CLI::App& app, SharedArguments& shared);

// The parameters of Cocone, --mode and --verify. `of_rho`: what else there is to be said of it.
void add_surface_options(CLI::App& app, SurfaceArguments& parameters, const std::string& of_rho);
void add_verify(CLI::App& app, bool& verify);

// Of what is on by default: CLI11's own negative flags ("!--no-...") stand with "{false}" in
// --help.
CLI::Option* add_switch_off(CLI::App& app, const std::string& name, bool& is_on,
                            const std::string& meaning);

void add_ascii(CLI::App& app, bool& ascii);

// --ascii and --float.
void add_writing(CLI::App& app, MeshWriteOptions& writing);

// --output, and how it is written. `of_ply`: what else there is to be said of that format.
CLI::Option* add_mesh_output(CLI::App& app, std::string& mesh, MeshWriteOptions& writing,
                             const std::string& of_ply = "");

void add_manifold_option(CLI::App& app, bool& manifold);

// `group`: the heading in --help.
void add_radius(CLI::App& app, std::optional<RadiusMode>& radius, const std::string& group);
void add_thresholds_of(CLI::App& app, ThresholdUse use, std::map<std::string, double>& given,
                       const std::string& group, const StageOptions& defaults = {});

void add_noise(CLI::App& app, NoiseHandling& noise, const std::string& meaning);

// --thin, --noise and its thresholds, of the clouds of an update.
void add_cloud_filter(CLI::App& app, CloudFilterArguments& arguments);
// `of_what`: of which points, with a blank before it.
void add_thin(CLI::App& app, std::optional<double>& distance, const std::string& of_what);

// `mesh`: the name of the argument that is densified.
void add_densify(CLI::App& app, const std::string& mesh, std::optional<double>& spacing);
void add_keep_coarse(CLI::App& app, bool& keeps);

void add_trim(CLI::App& app, std::optional<double>& max_edge, const std::string& what_for);

}  // namespace cocoon::app
