#include "io/weld_points.h"

#include <bit>

namespace cocoon {

namespace {

// Mixes 64 bits well (the finalizer of MurmurHash3, Appleby).
std::uint64_t mix(std::uint64_t bits) {
  bits ^= bits >> 33;
  bits *= 0xff51afd7ed558ccdULL;
  bits ^= bits >> 33;
  bits *= 0xc4ceb9fe1a85ec53ULL;
  return bits ^ (bits >> 33);
}

std::size_t hash_of(const Point& point) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    hash = mix(hash ^ std::bit_cast<std::uint64_t>(point[axis] + 0.0));  // -0 + 0 = 0
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace

std::size_t PointWelder::slot_of(const Point& point) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash_of(point) & mask;
  while (table_[slot] != empty && points_[table_[slot]] != point) slot = (slot + 1) & mask;
  return slot;
}

void PointWelder::grow() {
  table_.assign(2 * table_.size(), empty);
  for (std::size_t i = 0; i < points_.size(); ++i) table_[slot_of(points_[i])] = i;
}

std::size_t PointWelder::add(const Point& point) {
  std::size_t slot = slot_of(point);
  if (table_[slot] != empty) return table_[slot];
  if (2 * (points_.size() + 1) > table_.size()) {
    grow();
    slot = slot_of(point);
  }
  points_.push_back(point);
  return table_[slot] = points_.size() - 1;
}

}  // namespace cocoon
