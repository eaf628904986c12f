#include "delaunay/kernel/insertion_order.h"

#include <numeric>

#include "geom/spatial_order.h"

namespace cocoon {
namespace {

constexpr std::size_t min_sorted = 64;
constexpr std::uint64_t rounds_seed = 1;

}  // namespace

std::vector<std::uint32_t> insertion_order(Points points) {
  if (points.size() < min_sorted) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    return order;
  }
  const std::vector<PointId> along_curve = hilbert_order(points);
  std::vector<std::uint32_t> order = insertion_rounds(points.size(), rounds_seed).order;
  for (std::uint32_t& position : order) position = along_curve[position].value;
  return order;
}

}  // namespace cocoon
