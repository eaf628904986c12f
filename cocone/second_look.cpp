#include "cocone/second_look.h"

#include "cocone/energy/cell_energy.h"

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
  // In doubles: so many of the most that a cost counts as are beyond Energy.
  const auto units = [](double cost) { return 0x1p-20 * static_cast<double>(to_energy(cost)); };
  return units(costs.component_cost) * static_cast<double>(roughness.parts) +
         units(costs.handle_cost) / 2 * static_cast<double>(roughness.twice_handles) +
         units(costs.unused_cost) * static_cast<double>(roughness.unused_vertices);
}

}  // namespace cocoon
