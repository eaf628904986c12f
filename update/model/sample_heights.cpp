#include "update/model/sample_heights.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "update/model/reached_cells.h"

namespace cocoon {

namespace {

// Where the places may be.
std::vector<Point> with_moved_back(std::vector<Point> places, const Vec3& shift) {
  if (shift == Vec3{}) return places;
  const std::size_t given = places.size();
  places.reserve(2 * given);
  for (std::size_t k = 0; k < given; ++k) places.push_back(places[k] - shift);
  return places;
}

// Infinity beyond the reach of the facets.
double squared_height_as_it_lies(const NearFacets& near, const Point& sample) {
  const double bound = near.reach() * near.reach();
  const ClosestFacet closest = near.closest(sample, bound);
  return closest.triangle.is_none() ? std::numeric_limits<double>::infinity()
                                    : closest.squared_distance;
}

double squared_height(const NearFacets& near, const Point& sample, const Vec3& shift) {
  const double as_it_lies = squared_height_as_it_lies(near, sample);
  if (shift == Vec3{}) return as_it_lies;
  return std::min(as_it_lies, squared_height_as_it_lies(near, sample - shift));
}

}  // namespace

std::vector<double> squared_heights(const ModelIndex& model, Points places, double bound,
                                    const Vec3& shift) {
  const NearFacets near(model, with_moved_back({places.begin(), places.end()}, shift), bound);
  std::vector<double> heights;
  heights.reserve(places.size());
  for (const Point& p : places) heights.push_back(squared_height(near, p, shift));
  return heights;
}

std::vector<PointId> ids_off_model(const ModelIndex& model, Points samples, double distance,
                                   const Vec3& shift) {
  const std::vector<double> heights = squared_heights(model, samples, distance, shift);
  std::vector<PointId> off;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (heights[k] > distance * distance) off.push_back(PointId(k));
  }
  return off;
}

std::vector<Point> samples_off_model(const ModelIndex& model, Points samples, double distance,
                                     const Vec3& shift) {
  std::vector<Point> off;
  for (const PointId p : ids_off_model(model, samples, distance, shift)) {
    off.push_back(samples[p.index()]);
  }
  return off;
}

SampleHeights::SampleHeights(const ModelIndex& model, Points samples, Points places, double reach,
                             double bound, const Vec3& shift)
    : samples_(samples),
      shift_(shift),
      near_(model, with_moved_back(points_near(samples, places, reach), shift), bound) {}

double SampleHeights::squared(PointId sample) {
  const auto [entry, is_new] = known_.try_emplace(sample.index());
  if (is_new) entry->second = squared_height(near_, samples_[sample.index()], shift_);
  return entry->second;
}

}  // namespace cocoon
