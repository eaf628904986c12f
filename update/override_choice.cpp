#include "update/override_choice.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "geom/errors.h"

namespace cocoon {

namespace {

void set_fate(std::span<const RegionId> regions, bool goes, RegionChoice& choice) {
  for (const RegionId r : regions) {
    if (r.index() >= choice.replaced.size()) {
      throw InputError("there is no group " + std::to_string(r.value) + "; they are 0 to " +
                       std::to_string(choice.replaced.size() - 1));
    }
    choice.replaced[r] = goes ? 1 : 0;
    for (CloudChoice& cloud : choice.clouds) {
      for (RegionVerdict& verdict : cloud.regions) {
        if (verdict.region == r) verdict.under_cloud = goes;
      }
    }
  }
}

}  // namespace

void override_choice(const RegionOverrides& overrides, RegionChoice& choice) {
  if (overrides.is_empty()) return;
  for (const RegionId r : overrides.replaced) {
    if (std::count(overrides.kept.begin(), overrides.kept.end(), r) == 0) continue;
    throw InputError("group " + std::to_string(r.value) +
                     " is said to be replaced and to be kept; say one of them");
  }
  if (choice.replaced.empty()) {
    throw InputError("the rims cut no group out of the model; none can be replaced or kept");
  }
  if (choice.status == ChoiceStatus::ambiguous) {
    for (CloudChoice& cloud : choice.clouds) {
      for (RegionVerdict& verdict : cloud.regions) verdict.under_cloud = false;
    }
    choice.status = ChoiceStatus::ok;
  }
  set_fate(overrides.replaced, true, choice);
  set_fate(overrides.kept, false, choice);
  if (std::count(choice.replaced.begin(), choice.replaced.end(), 0) == 0) {
    throw InputError("all groups would be replaced; keep one of them");
  }
}

}  // namespace cocoon
