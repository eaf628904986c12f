#include "geom/search/equal_points.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "geom/arrays/visit_where.h"
#include "geom/box.h"
#include "geom/search/point_hash.h"

namespace cocoon {
namespace {

class BitTable {
 public:
  explicit BitTable(std::size_t size) : words_(size / 64, 0) {}
  // Sets the bit; whether it was set before.
  bool set(std::uint64_t at) {
    std::uint64_t& word = words_[at / 64];
    const std::uint64_t bit = std::uint64_t{1} << (at % 64);
    const bool before = (word & bit) != 0;
    word |= bit;
    return before;
  }
  bool contains(std::uint64_t at) const { return ((words_[at / 64] >> (at % 64)) & 1U) != 0; }

 private:
  std::vector<std::uint64_t> words_;
};

// The positions of all points that share their place in the table with others; the first `distinct`
// do not count as others of each other, and only those `near` are looked at.
std::vector<std::uint32_t> look_alikes(Points points, std::size_t distinct,
                                       std::span<const std::uint32_t> near) {
  const std::size_t hashed = points.size() - distinct;
  const std::size_t size = std::bit_ceil(std::max<std::size_t>(16 * hashed, 64));
  BitTable met(size);
  BitTable met_again(size);
  const auto place_of = [&](const Point& p) { return point_hash(p) & (size - 1); };
  for (const Point& p : points.subspan(distinct)) {
    const std::uint64_t at = place_of(p);
    if (met.set(at)) met_again.set(at);
  }
  std::vector<std::uint32_t> found;
  for (const std::uint32_t i : near) {
    const std::uint64_t at = place_of(points[i]);
    if (!met.contains(at)) continue;
    met_again.set(at);
    found.push_back(i);
  }
  for (std::size_t i = distinct; i < points.size(); ++i) {
    if (met_again.contains(place_of(points[i]))) found.push_back(static_cast<std::uint32_t>(i));
  }
  return found;
}

}  // namespace

std::vector<RepeatedPoint> repeated_points(Points points, std::size_t distinct) {
  std::vector<std::uint32_t> near;
  const Box box = box_of(points.subspan(distinct));
  visit_where(
      distinct, [&](std::size_t i) { return contains(box, points[i]); },
      [&](std::size_t i) { near.push_back(static_cast<std::uint32_t>(i)); });
  return repeated_points(points, distinct, near);
}

std::vector<RepeatedPoint> repeated_points(Points points, std::size_t distinct,
                                           std::span<const std::uint32_t> near) {
  std::vector<std::uint32_t> order = look_alikes(points, distinct, near);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto by_position = points[a] <=> points[b];
    return by_position != 0 ? by_position < 0 : a < b;
  });
  std::vector<RepeatedPoint> repeated;
  std::uint32_t first = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || points[order[k]] != points[order[k - 1]]) {
      first = order[k];
    } else {
      repeated.push_back({order[k], first});
    }
  }
  std::sort(repeated.begin(), repeated.end(),
            [](const RepeatedPoint& a, const RepeatedPoint& b) { return a.point < b.point; });
  return repeated;
}

std::vector<Point> distinct_points(Points points) {
  std::vector<Point> distinct(points.begin(), points.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  return distinct;
}

}  // namespace cocoon
