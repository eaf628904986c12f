#include "geom/search/neighbor_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/errors.h"
#include "geom/search/box_tree.h"
#include "geom/search/equal_points.h"
#include "geom/working_scale.h"

namespace cocoon {

double median_neighbor_distance(Points points, std::size_t k) {
  constexpr std::size_t asked = 500;
  if (k == 0) throw InputError("the distance of neighbor 0 is asked for; count from 1");
  std::vector<Point> different = distinct_points(points);
  if (different.size() <= k) return 0;
  const double scale = working_scale(different);
  if (scale != 1) different = scaled(different, scale);
  const BoxTree tree = tree_of_points(different);
  std::vector<double> distances;
  const std::size_t step = std::max<std::size_t>(1, different.size() / asked);
  for (std::size_t i = 0; i < different.size(); i += step) {
    // Increasing, squared.
    std::vector<double> nearest(k, std::numeric_limits<double>::infinity());
    tree.visit_near(different[i], nearest.back(), [&](std::uint32_t slot) {
      const std::uint32_t other = tree.items()[slot];
      const double distance = squared_distance(different[other], different[i]);
      if (other != i && distance < nearest.back()) {
        nearest.pop_back();
        nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), distance), distance);
      }
      return nearest.back();
    });
    distances.push_back(nearest.back());
  }
  return std::sqrt(median(std::move(distances))) / scale;
}

}  // namespace cocoon
