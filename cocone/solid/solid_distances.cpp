#include "cocone/solid/solid_distances.h"

#include <algorithm>
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
    if (const std::optional<double> known = find(*memory_, places[k])) {
      distances[k] = *known;
    } else {
      unknown.push_back(places[k]);
      position.push_back(k);
    }
  }
  if (unknown.empty()) return distances;
  const std::vector<double> asked = signed_distances(*solid_, unknown, execution);
  for (std::size_t i = 0; i < asked.size(); ++i) distances[position[i]] = asked[i];
  remember(unknown, asked);
  return distances;
}

std::optional<double> SolidDistances::find(const Memory& memory, const Point& place) {
  const auto found =
      std::lower_bound(memory.begin(), memory.end(), place,
                       [](const Known& known, const Point& other) { return known.place < other; });
  if (found == memory.end() || found->place != place) return {};
  return found->distance;
}

void SolidDistances::remember(Points places, const std::vector<double>& distances) const {
  const auto before = static_cast<std::ptrdiff_t>(memory_->size());
  memory_->reserve(memory_->size() + places.size());
  for (std::size_t k = 0; k < places.size(); ++k) memory_->push_back({places[k], distances[k]});
  const auto by_place = [](const Known& a, const Known& b) { return a.place < b.place; };
  const auto first_new = memory_->begin() + before;
  std::sort(first_new, memory_->end(), by_place);
  std::inplace_merge(memory_->begin(), first_new, memory_->end(), by_place);
}

}  // namespace cocoon
