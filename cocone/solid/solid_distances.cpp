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
  std::vector<Point> unknown;  // in the order given: neighbors are near each other
  for (const Point& p : places) {
    if (!find(*memory_, p)) unknown.push_back(p);
  }
  remember(unknown, signed_distances(*solid_, unknown, execution));
  std::vector<double> distances;
  distances.reserve(places.size());
  for (const Point& p : places) distances.push_back(*find(*memory_, p));
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
