#include "update/override_choice.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "geom/errors.h"

namespace cocoon {

namespace {

bool has(const std::vector<RegionId>& regions, RegionId region) {
  return std::find(regions.begin(), regions.end(), region) != regions.end();
}

void require_overrides(const RegionOverrides& overrides, std::size_t num_regions) {
  if (num_regions == 0) {
    throw InputError("the rims cut no group out of the model; none can be replaced or kept");
  }
  for (const std::vector<RegionId>* regions : {&overrides.replaced, &overrides.kept}) {
    for (const RegionId r : *regions) {
      if (r.index() < num_regions) continue;
      throw InputError("there is no group " + std::to_string(r.value) + "; they are 0 to " +
                       std::to_string(num_regions - 1) + "; name one of these");
    }
  }
  for (const RegionId r : overrides.replaced) {
    if (!has(overrides.kept, r)) continue;
    throw InputError("group " + std::to_string(r.value) +
                     " is said to be replaced and to be kept; say one of them");
  }
}

// Does nothing if a cloud is left that nobody has decided.
void settle(const RegionOverrides& overrides, RegionChoice& choice) {
  for (const CloudChoice& cloud : choice.clouds) {
    if (cloud.is_ambiguous && !overrides.decides(cloud)) return;
  }
  for (CloudChoice& cloud : choice.clouds) {
    if (!cloud.is_ambiguous) continue;
    for (RegionVerdict& verdict : cloud.regions) verdict.under_cloud = false;
  }
  choice.status = ChoiceStatus::ok;
  const std::size_t num_regions = choice.replaced.size();
  choice.replaced = std::move(choice.replaced_by_clear);
  choice.replaced.resize(num_regions, 0);
}

enum class Fate { kept, replaced };

void set_fate(std::span<const RegionId> regions, Fate fate, RegionChoice& choice) {
  const bool goes = fate == Fate::replaced;
  for (const RegionId r : regions) {
    choice.replaced[r] = goes ? 1 : 0;
    for (CloudChoice& cloud : choice.clouds) {
      for (RegionVerdict& verdict : cloud.regions) {
        if (verdict.region == r) verdict.under_cloud = goes;
      }
    }
  }
}

}  // namespace

bool RegionOverrides::names(RegionId region) const {
  return has(replaced, region) || has(kept, region);
}

bool RegionOverrides::decides(const CloudChoice& cloud) const {
  const auto goes = [&](const RegionVerdict& v) { return has(replaced, v.region); };
  const auto is_named = [&](const RegionVerdict& v) { return names(v.region); };
  return std::any_of(cloud.regions.begin(), cloud.regions.end(), goes) ||
         std::all_of(cloud.regions.begin(), cloud.regions.end(), is_named);
}

void override_choice(const RegionOverrides& overrides, RegionChoice& choice,
                     std::span<const RegionId> islands) {
  if (overrides.is_empty()) return;
  require_overrides(overrides, choice.replaced.size());
  if (choice.status == ChoiceStatus::ambiguous) settle(overrides, choice);
  if (choice.status == ChoiceStatus::ambiguous) return;
  const bool stays_another =
      std::any_of(overrides.kept.begin(), overrides.kept.end(), [&](RegionId r) {
        return r != choice.kept_largest &&
               std::find(islands.begin(), islands.end(), r) == islands.end();
      });
  if (!choice.kept_largest.is_none() && stays_another) {
    choice.replaced[std::exchange(choice.kept_largest, {})] = 1;
  }
  set_fate(overrides.replaced, Fate::replaced, choice);
  set_fate(overrides.kept, Fate::kept, choice);
  if (std::count(choice.replaced.begin(), choice.replaced.end(), 0) == 0) {
    throw InputError("all groups would be replaced; keep one of them");
  }
}

}  // namespace cocoon
