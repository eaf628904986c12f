#include "cocone/second_look.h"

namespace cocoon {

bool is_contradictory(const SecondLookOptions& options, const CellMarks& marks,
                      std::size_t samples) {
  const auto are_more = [&](std::size_t count, double share) {
    return static_cast<double>(count) > share * static_cast<double>(samples);
  };
  return options.enabled && marks.conflicts > options.max_conflicts &&
         are_more(marks.conflicts, options.max_conflict_share) &&
         !are_more(marks.poor_cells, options.max_poor_per_sample);
}

}  // namespace cocoon
