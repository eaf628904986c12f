// What every local update must hold to, and the sphere and the hill on it that tests update.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/triangle_mesh.h"
#include "tests/gallery.h"
#include "update/update_model.h"

namespace cocoon::testing {

using Clouds = std::vector<std::vector<Point>>;
using Predicate = std::function<bool(const Point&)>;

// A smooth hill: 1 in the middle, 0 from `width` on.
inline double hill(double distance, double width) {
  const double t = distance / width;
  return t < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

// A flat cap around `center`, with a hill in its middle.
inline std::vector<Point> cap_with_hill(const Point& center, double height) {
  std::vector<Point> cap;
  Random random(9);
  for (int i = 0; i < 48; ++i) {
    for (int j = 0; j < 48; ++j) {
      const double x = 0.5 * i + random.uniform(-0.1, 0.1) - 12;
      const double y = 0.5 * j + random.uniform(-0.1, 0.1) - 12;
      const double r = std::hypot(x, y);
      if (r < 8) cap.push_back(center + Vec3{x, y, height * hill(r, 6)});
    }
  }
  return cap;
}

// n points on the unit sphere, evenly spread along a spiral, with a little noise across.
inline std::vector<Point> sphere_points(std::size_t n, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Point> points = gallery::even_sphere(n);
  const double spacing = std::sqrt(4 * std::numbers::pi / static_cast<double>(n));
  for (Point& p : points) p = unit(p + 0.1 * spacing * random.on_unit_sphere());
  return points;
}

inline double polar_angle(const Point& p, const Vec3& axis) {
  return std::acos(std::clamp(dot(unit(p), axis), -1.0, 1.0));
}

// What every update must be: closed, manifold, with all its vertices from the input. Kept vertices
// keep their bits; what must go is gone, what must stay is there.
inline void expect_local_update(const TriangleMesh& model, const Clouds& clouds,
                                const UpdateResult& result, const Predicate& must_go,
                                const Predicate& must_stay) {
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
  std::size_t cloud_points = 0;
  for (const std::vector<Point>& cloud : clouds) cloud_points += cloud.size();
  const Replacement& replacement = result.replacement;
  EXPECT_EQ(replacement.points.size(),
            replacement.vertices.kept + cloud_points - replacement.duplicates);
  EXPECT_EQ(replacement.vertices.kept + replacement.vertices.replaced, model.points.size());
  ASSERT_EQ(result.vertex_map.size(), model.points.size());
  std::size_t left_over = 0;
  std::size_t lost = 0;
  for (const VertexId v : model.points.ids()) {
    const VertexId mapped = result.vertex_map[v];
    if (!mapped.is_none()) {
      EXPECT_EQ(result.mesh.points[mapped], model.points[v]);
    }
    left_over += must_go(model.points[v]) && !mapped.is_none() ? 1U : 0U;
    lost += must_stay(model.points[v]) && mapped.is_none() ? 1U : 0U;
  }
  EXPECT_EQ(left_over, 0U);
  EXPECT_EQ(lost, 0U);
}

}  // namespace cocoon::testing
