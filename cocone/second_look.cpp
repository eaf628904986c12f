#include "cocone/second_look.h"

#include <algorithm>

namespace cocoon {

bool is_contradictory(const SecondLookOptions& options, std::size_t conflicts,
                      std::size_t samples) {
  const double share = options.max_conflict_share * static_cast<double>(samples);
  return options.enabled && conflicts > options.max_conflicts &&
         static_cast<double>(conflicts) > share;
}

double cost_of(const SurfaceRoughness& roughness, const CleanUpOptions& costs) {
  constexpr double most = 0x1p20;  // as in the clean-up
  return std::min(costs.component_cost, most) * static_cast<double>(roughness.parts) +
         std::min(costs.handle_cost, most) / 2 * static_cast<double>(roughness.twice_handles) +
         std::min(costs.unused_cost, most) * static_cast<double>(roughness.unused_vertices);
}

}  // namespace cocoon
