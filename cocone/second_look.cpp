#include "cocone/second_look.h"

#include <algorithm>

namespace cocoon {

bool calls_for_second_look(const SecondLookOptions& options, const Contradictions& found) {
  const auto are_more = [&](std::size_t count, double per_sample) {
    return static_cast<double>(count) > per_sample * static_cast<double>(found.samples);
  };
  return options.enabled && found.conflicts > options.max_conflicts &&
         are_more(found.conflicts, options.max_conflict_share) &&
         !are_more(found.poor_cells, options.max_poor_per_sample);
}

double cost_of(const SurfaceRoughness& roughness, const CleanUpOptions& costs) {
  constexpr double most = 0x1p20;  // as in the clean-up
  return std::min(costs.component_cost, most) * static_cast<double>(roughness.parts) +
         std::min(costs.handle_cost, most) / 2 * static_cast<double>(roughness.twice_handles) +
         std::min(costs.unused_cost, most) * static_cast<double>(roughness.unused_vertices);
}

}  // namespace cocoon
