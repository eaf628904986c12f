#include "app/arguments/option_rules.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <variant>
#include <vector>

#include "app/arguments/thresholds.h"
#include "io/file_format.h"

namespace cocoon::app {

namespace {

// What is set of the noise filter needs one. Noise is filtered before anything else is built, which
// neither the open surface nor a session, which keeps the triangulation of all points, has a place
// for.
void require_possible_noise_filter(const ReconstructArguments& arguments) {
  if (arguments.noise == NoiseHandling::none) {
    std::vector<std::string> given;
    if (!arguments.noise_keep_good) given.push_back("--noise-skin-only");
    if (!arguments.noise_spare_good) given.push_back("--noise-spacing-only");
    append_given(ThresholdUse::outliers, arguments.thresholds, given);
    append_given(ThresholdUse::noise, arguments.thresholds, given);
    if (given.empty()) return;
    throw UsageError(fmt::format("{} needs --noise robust", given.front()));
  }
  if (arguments.surface != SurfaceKind::tight)
    throw UsageError("--noise robust needs --surface tight");
  if (!arguments.session.empty()) {
    throw UsageError(
        "--noise robust leaves points out and --session keeps all of them: leave out one of the "
        "two");
  }
  if (arguments.densify) {
    throw UsageError("samples of a mesh have no noise: leave out --noise robust, or --densify");
  }
}

// Given options of the stages that close a surface, but for --cavities.
std::vector<std::string> of_tight_stages(const ReconstructArguments& arguments) {
  std::vector<std::string> names;
  if (!arguments.deferred_seeding) names.push_back("--no-deferred-seeding");
  if (!arguments.second_look) names.push_back("--no-second-look");
  if (!arguments.clean_up) names.push_back("--no-clean-up");
  append_given(ThresholdUse::tight, arguments.thresholds, names);
  append_given(ThresholdUse::second_look, arguments.thresholds, names);
  append_given(ThresholdUse::clean_up, arguments.thresholds, names);
  return names;
}

void require_use_of_options(const ReconstructArguments& arguments) {
  if (arguments.surface == SurfaceKind::tight) return;
  std::vector<std::string> names = of_tight_stages(arguments);
  if (arguments.cavities) names.push_back("--cavities");
  if (arguments.trim) names.push_back("--trim");
  if (!names.empty()) throw UsageError(names.front() + " needs --surface tight");
}

// Given options that a session does not keep: it has the parameters of surface_options.h only.
// Hollows need no option, once the model has them.
std::vector<std::string> unknown_to_sessions(const ReconstructArguments& arguments) {
  std::vector<std::string> names;
  if (arguments.radius) names.push_back("--radius");
  append_given(ThresholdUse::cocone, arguments.thresholds, names);
  const std::vector<std::string> tight = of_tight_stages(arguments);
  names.insert(names.end(), tight.begin(), tight.end());
  return names;
}

void require_possible_session(const ReconstructArguments& arguments) {
  if (arguments.session.empty()) return;
  if (arguments.surface != SurfaceKind::tight) {
    throw UsageError("--session needs the watertight surface: leave out --surface cocone");
  }
  if (arguments.trim) {
    throw UsageError("--session needs the watertight surface: leave out --trim");
  }
  const std::vector<std::string> names = unknown_to_sessions(arguments);
  if (names.empty()) return;
  throw UsageError(fmt::format("a session does not keep {}: leave {} out, or leave out --session",
                               fmt::join(names, ", "), names.size() == 1 ? "it" : "them"));
}

void require_rules(const ReconstructArguments& arguments) {
  if (arguments.densify && arguments.thin) {
    throw UsageError("--densify adds samples and --thin leaves points out: leave out one of them");
  }
  require_possible_noise_filter(arguments);
  require_use_of_options(arguments);
  require_possible_session(arguments);
}

void require_rules(const BoundaryArguments& arguments) {
  if (arguments.label_samples && format_of(arguments.mesh) != FileFormat::ply) {
    throw UsageError("--label-samples: only PLY keeps what is said of vertices; name a .ply file");
  }
}

void require_use_of_filter(const CloudFilterArguments& arguments) {
  if (arguments.noise != NoiseHandling::none) return;
  const std::vector<std::string> given =
      given_thresholds(ThresholdUse::outliers, arguments.thresholds);
  if (!given.empty()) throw UsageError(fmt::format("{} needs --noise robust", given.front()));
}

void require_possible_groups(const UpdateArguments& arguments) {
  for (const std::uint32_t group : arguments.kept_groups) {
    const auto& replaced = arguments.replaced_groups;
    if (std::find(replaced.begin(), replaced.end(), group) == replaced.end()) continue;
    throw UsageError(
        fmt::format("group {} is in --keep-groups and in --replace-groups; leave it out of one of "
                    "them",
                    group));
  }
}

template <class Arguments>
void require_use_of_keep_coarse(const Arguments& arguments) {
  if (arguments.densify && arguments.keep_coarse) {
    throw UsageError("--densify adds samples and --keep-coarse none: leave out one of them");
  }
}

// The map names vertices of the mesh by number.
void require_rules(const UpdateArguments& arguments) {
  if (!arguments.map.empty() && format_of(arguments.mesh) == FileFormat::stl) {
    throw UsageError(arguments.mesh +
                     ": STL does not keep the numbers of vertices that --map writes; use .ply, "
                     ".obj or .off, or leave out --map");
  }
  require_use_of_keep_coarse(arguments);
  require_possible_groups(arguments);
  require_use_of_filter(arguments.filter);
}

void require_rules(const WatchArguments& arguments) {
  require_use_of_keep_coarse(arguments);
  require_use_of_filter(arguments.filter);
}

template <class Arguments>
void require_rules(const Arguments&) {}

// --float and --ascii where they would do nothing.
void require_use_of_writing(const std::string& mesh, const MeshWriteOptions& writing) {
  if (mesh.empty() && (writing.single_precision || writing.ascii)) {
    throw UsageError("--float and --ascii are about the output; name one by -o");
  }
  if (writing.single_precision && format_of(mesh) != FileFormat::ply) {
    throw UsageError(
        "--float: only PLY has floats or doubles as one likes; name a .ply file, or leave it out");
  }
}

}  // namespace

void require_possible_options(const Command& command) {
  const auto require_all = [](const auto& arguments) {
    if constexpr (requires { arguments.writing; }) {
      require_use_of_writing(arguments.mesh, arguments.writing);
    }
    require_rules(arguments);
  };
  std::visit(require_all, command);
}

}  // namespace cocoon::app
