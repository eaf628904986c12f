#include "update/cloud/scanned_places.h"

#include <algorithm>

namespace cocoon {

void ScannedPlaces::add(Points samples, double reach) {
  if (samples.empty()) return;
  Box box = box_of(samples);
  box.enlarge(reach);
  sets_.push_back({NearestPointTree(samples), reach, box});
}

bool ScannedPlaces::contain(const Point& place) const {
  return std::any_of(sets_.begin(), sets_.end(), [&](const Reached& set) {
    return contains(set.box, place) &&
           set.samples.nearest(place).squared_distance <= set.reach * set.reach;
  });
}

Box ScannedPlaces::box() const {
  Box all;
  for (const Reached& set : sets_) all.include(set.box);
  return all;
}

}  // namespace cocoon
