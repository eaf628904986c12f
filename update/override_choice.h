// What a person says about regions of the model, whatever their angles.
#pragma once

#include <vector>

#include "geom/ids.h"
#include "update/choose_regions.h"

namespace cocoon {

// Numbers are those of the regions of the same update without it (UpdateResult::regions): equal
// models, clouds and options give equal ones.
struct RegionOverrides {
  std::vector<RegionId> replaced = {};
  std::vector<RegionId> kept = {};

  bool is_empty() const { return replaced.empty() && kept.empty(); }
};

// Enters them in the choice, for every cloud that saw such a region. A choice that was ambiguous,
// by which all would stay, is one now: of its regions those go that are said to. Does nothing if
// there are none. Complexity: O(regions + verdicts).
// Errors: InputError, one line, for a region that the model does not have, one that is to go and to
// stay, and if none would stay. Source: ours.
void override_choice(const RegionOverrides& overrides, RegionChoice& choice);

}  // namespace cocoon
