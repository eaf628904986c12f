// What a person says about regions of the model, whatever their angles.
#pragma once

#include <span>
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
  // Whether something is said of the region.
  bool names(RegionId region) const;
  // Whether a cloud that cannot tell its regions apart is decided: one of them is said to go, or
  // something is said of each.
  bool decides(const CloudChoice& cloud) const;
};

// Enters them in the choice, for every cloud that saw such a region. If they decide all clouds that
// cannot tell their regions apart, the choice is ambiguous no longer: of those clouds' regions
// those go that are said to, and the other clouds decide as ever. Does nothing if there are no
// overrides. A region that was kept only since all others went (RegionChoice::kept_largest) goes if
// another one is said to stay that is no island (contradicted_islands.h). Complexity: O(regions +
// verdicts) for each override. Errors: InputError, one line, for a region that the model does not
// have, one that is to go and to stay, and if none would stay. Source: ours.
void override_choice(const RegionOverrides& overrides, RegionChoice& choice,
                     std::span<const RegionId> islands = {});

}  // namespace cocoon
