#include "update/cloud/scanned_places.h"

#include <algorithm>

namespace cocoon {

void ScannedPlaces::add(Points samples, double reach) {
  if (samples.empty()) return;
  own_.push_back(std::make_unique<const NearestPointTree>(samples));
  add(*own_.back(), reach);
}

void ScannedPlaces::add(const NearestPointTree& samples, double reach) {
  Box box = samples.box();
  box.enlarge(reach);
  sets_.push_back({&samples, reach, box});
}

bool ScannedPlaces::contain(const Point& place) const {
  return std::any_of(sets_.begin(), sets_.end(), [&](const Reached& set) {
    return contains(set.box, place) && set.samples->any_near(place, set.reach);
  });
}

Box ScannedPlaces::box() const {
  Box all;
  for (const Reached& set : sets_) all.include(set.box);
  return all;
}

}  // namespace cocoon
