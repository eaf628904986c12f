// Points that come and go, and what a DynamicTightCocone makes of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
#include <vector>

#include "cocone/dynamic_tight_cocone.h"
#include "tests/cocone/equal_reconstructions.h"

namespace cocoon {

struct ChangingPoints {
  std::vector<Point> points;
  std::vector<PointId> old_position;  // of each before the last change; none: new

  explicit ChangingPoints(std::vector<Point> start) : points(std::move(start)) {}

  template <class Goes>
  void change(Goes goes, const std::vector<Point>& added) {
    std::vector<Point> next;
    old_position.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (goes(points[i])) continue;
      next.push_back(points[i]);
      old_position.push_back(PointId(i));
    }
    next.insert(next.end(), added.begin(), added.end());
    old_position.resize(next.size());
    points = std::move(next);
  }
};

// Of even samples of the unit sphere.
inline double spacing_on_sphere(std::size_t n) {
  return std::sqrt(4 * std::numbers::pi / static_cast<double>(n));
}

// Carries the change out, and compares with a reconstruction of the points. Was it local?
inline bool is_local_and_equal(DynamicTightCocone& cocone, const ChangingPoints& changing,
                               ReconstructResult& expected) {
  const std::size_t before = cocone.local_changes();
  const ReconstructResult actual = cocone.replace(changing.points, changing.old_position);
  expected = reconstruct_tight(changing.points, cocone.options());
  expect_equal_reconstruction(actual, expected);
  return cocone.local_changes() > before;
}

}  // namespace cocoon
