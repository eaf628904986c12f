#include "update/cloud/scanned_places.h"

#include <algorithm>

namespace cocoon {

void ScannedPlaces::add(Points samples, double reach) {
  if (samples.empty()) return;
  Box box = box_of(samples);
  box.enlarge(reach);
  scans_.push_back({NearestPointTree(samples), reach, box});
}

bool ScannedPlaces::contain(const Point& place) const {
  return std::any_of(scans_.begin(), scans_.end(), [&](const Scan& scan) {
    return contains(scan.box, place) &&
           scan.samples.nearest(place).squared_distance <= scan.reach * scan.reach;
  });
}

}  // namespace cocoon
