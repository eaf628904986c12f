#include "update/model/sample_heights.h"

#include <cstddef>
#include <limits>
#include <utility>

#include "update/model/near_facets.h"

namespace cocoon {

std::vector<double> squared_heights(const ModelIndex& model, Points places, double bound) {
  const NearFacets near(model, places, bound);
  std::vector<double> heights;
  heights.reserve(places.size());
  for (const Point& p : places) {
    const ClosestFacet closest = near.closest(p, bound * bound, [](TriangleId) { return true; });
    heights.push_back(closest.triangle.is_none() ? std::numeric_limits<double>::infinity()
                                                 : closest.squared_distance);
  }
  return heights;
}

std::vector<PointId> which_are_off(const ModelIndex& model, Points samples, double distance) {
  const std::vector<double> heights = squared_heights(model, samples, distance);
  std::vector<PointId> off;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (heights[k] > distance * distance) off.push_back(PointId(k));
  }
  return off;
}

std::vector<Point> samples_off(const ModelIndex& model, Points samples, double distance) {
  std::vector<Point> off;
  for (const PointId p : which_are_off(model, samples, distance)) {
    off.push_back(samples[p.index()]);
  }
  return off;
}

SampleHeights::SampleHeights(std::vector<Point> samples, std::vector<double> squared_heights)
    : samples_(std::move(samples)), squared_heights_(std::move(squared_heights)) {
  if (!samples_.empty()) tree_ = tree_of_points(samples_);
}

}  // namespace cocoon
