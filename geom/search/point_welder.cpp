#include "geom/search/point_welder.h"

#include "geom/search/point_hash.h"

namespace cocoon {

std::size_t PointWelder::slot_of(const Point& point) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = point_hash(point) & mask;
  while (table_[slot] != none && points_[table_[slot]] != point) slot = (slot + 1) & mask;
  return slot;
}

void PointWelder::grow() {
  table_.assign(2 * table_.size(), none);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (is_finite(points_[i])) table_[slot_of(points_[i])] = i;
  }
}

std::size_t PointWelder::find(const Point& point) const {
  return is_finite(point) ? table_[slot_of(point)] : none;
}

std::size_t PointWelder::add(const Point& point) {
  if (!is_finite(point)) {
    points_.push_back(point);
    return points_.size() - 1;
  }
  std::size_t slot = slot_of(point);
  if (table_[slot] != none) return table_[slot];
  if (2 * (points_.size() + 1) > table_.size()) {
    grow();
    slot = slot_of(point);
  }
  points_.push_back(point);
  return table_[slot] = points_.size() - 1;
}

}  // namespace cocoon
