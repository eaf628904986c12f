#include "app/report/update_findings.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

#include "cocone/checks/surface_doubts.h"

namespace cocoon::app {

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

namespace {

std::string note_of_crowded(const CrowdedSamples& found) {
  const bool in_layers = found.in_layers > 0;
  return fmt::format(
      "{} of {} samples lie closer to others than {:.2g}, as in {}: if handles or parts of the "
      "surface are wrong, try {}--thin {:.2g}",
      found.closer, found.of, found.distance,
      in_layers ? "layers of views that are out of register" : "a scan finer than the model",
      in_layers ? "" : "--densify where the model is a mesh with large triangles, else ",
      found.distance);
}

}  // namespace

std::vector<std::string> notes_of_clouds(const UpdateResult& result,
                                         const std::vector<std::string>& names,
                                         const UpdateOptions& options) {
  std::vector<std::string> notes;
  for (std::size_t c = 0; c < result.clouds.size(); ++c) {
    const CloudSurface& surface = result.clouds[c].surface;
    const SpacingRange& range = surface.spacing;
    if (!range.is_uneven(options.cloud.density.min_ratio)) continue;
    const char* what = surface.set_aside > 0
                           ? "few of the dense ones were looked at to find its rim"
                           : "one limit of distance does not fit both";
    notes.push_back(
        fmt::format("{}: samples are {:.2g} apart in some places and {:.2g} in others, and {}; if "
                    "something is wrong, try --thin {:.2g}",
                    names[c], range.low, range.high, what, range.high));
  }
  // What was left out is told as a warning.
  if (result.crowded.closer > 0 && result.replacement.left_out == 0) {
    notes.push_back(note_of_crowded(result.crowded));
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

}  // namespace cocoon::app
