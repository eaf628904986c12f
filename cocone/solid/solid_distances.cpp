#include "cocone/solid/solid_distances.h"

#include <bit>
#include <cstddef>
#include <utility>

#include "geom/search/point_hash.h"
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
    if (const double* known = memory_->find(places[k])) {
      distances[k] = *known;
    } else {
      unknown.push_back(places[k]);
      position.push_back(k);
    }
  }
  if (unknown.empty()) return distances;
  const std::vector<double> asked = signed_distances(*solid_, unknown, execution);
  for (std::size_t i = 0; i < asked.size(); ++i) distances[position[i]] = asked[i];
  memory_->add(unknown, asked);
  return distances;
}

const double* SolidDistances::Memory::find(const Point& place) const {
  if (known_.empty()) return nullptr;
  const std::uint32_t at = table_[slot_of(place)];
  return at == none ? nullptr : &known_[at].distance;
}

void SolidDistances::Memory::add(Points places, const std::vector<double>& distances) {
  known_.reserve(known_.size() + places.size());
  std::size_t next = known_.size();
  for (std::size_t k = 0; k < places.size(); ++k) known_.push_back({places[k], distances[k]});
  if (const std::size_t size = std::bit_ceil(2 * known_.size()); size > table_.size()) {
    table_.assign(size, none);
    next = 0;
  }
  for (; next < known_.size(); ++next) {
    table_[slot_of(known_[next].place)] = static_cast<std::uint32_t>(next);
  }
}

// Where a place is in the table, or would be.
std::size_t SolidDistances::Memory::slot_of(const Point& place) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = point_hash(place) & mask;
  while (table_[slot] != none && known_[table_[slot]].place != place) slot = (slot + 1) & mask;
  return slot;
}

}  // namespace cocoon
