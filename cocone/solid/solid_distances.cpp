#include "cocone/solid/solid_distances.h"

#include <cstddef>
#include <utility>

#include "geom/signed_distance.h"

namespace cocoon {

SolidDistances::SolidDistances(const TriangleMesh& solid)
    : solid_(std::shared_ptr<const void>(), &solid) {}

SolidDistances::SolidDistances(std::shared_ptr<const TriangleMesh> solid)
    : solid_(std::move(solid)), memory_(std::make_shared<Memory>()) {}

std::vector<double> SolidDistances::at(Points places, const Execution& execution) const {
  if (!memory_) return signed_distances(*solid_, places, execution);
  std::vector<double> distances(places.size());
  std::vector<Point> unknown;  // in the order given: neighbors are near each other
  std::vector<std::size_t> position;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t known = memory_->welder.find(places[k]);
    if (known != PointWelder::none) {
      distances[k] = memory_->distances[known];
    } else {
      unknown.push_back(places[k]);
      position.push_back(k);
    }
  }
  if (unknown.empty()) return distances;
  const std::vector<double> asked = signed_distances(*solid_, unknown, execution);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    distances[position[i]] = asked[i];
    const bool is_new = memory_->welder.add(unknown[i]) == memory_->distances.size();
    if (is_new) memory_->distances.push_back(asked[i]);
  }
  return distances;
}

}  // namespace cocoon
