#include "cocone/second_look.h"

namespace cocoon {

bool is_contradictory(const SecondLookOptions& options, std::size_t conflicts,
                      std::size_t samples) {
  const double share = options.max_conflict_share * static_cast<double>(samples);
  return options.enabled && conflicts > options.max_conflicts &&
         static_cast<double>(conflicts) > share;
}

}  // namespace cocoon
