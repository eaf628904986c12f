#include "update/model/sample_heights.h"

#include <cstddef>
#include <limits>

#include "update/model/reached_cells.h"

namespace cocoon {

namespace {

// Infinity beyond the reach of the facets.
double squared_height(const NearFacets& near, const Point& sample) {
  const double bound = near.reach() * near.reach();
  const ClosestFacet closest = near.closest(sample, bound, [](TriangleId) { return true; });
  return closest.triangle.is_none() ? std::numeric_limits<double>::infinity()
                                    : closest.squared_distance;
}

}  // namespace

std::vector<double> squared_heights(const ModelIndex& model, Points places, double bound) {
  const NearFacets near(model, places, bound);
  std::vector<double> heights;
  heights.reserve(places.size());
  for (const Point& p : places) heights.push_back(squared_height(near, p));
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

SampleHeights::SampleHeights(const ModelIndex& model, Points samples, Points places, double reach,
                             double bound)
    : samples_(samples), near_(model, points_near(samples, places, reach), bound) {}

double SampleHeights::squared(PointId sample) {
  const auto [entry, is_new] = known_.try_emplace(sample.index());
  if (is_new) entry->second = squared_height(near_, samples_[sample.index()]);
  return entry->second;
}

}  // namespace cocoon
