#include "update/cloud/outward_normals.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A block, and a scan of its top, which is at z = 12, with a hill, and the same again some way
// apart.
struct ScannedTop {
  TriangleMesh block = testing::block(26, 26, 12);
  ModelIndex model{block};
  std::vector<Point> cloud;
  CloudSurface surface;
  Overlap overlap;

  explicit ScannedTop(const Vec3& apart) {
    Random random(5);
    for (int i = 0; i < 29; ++i) {
      for (int j = 0; j < 29; ++j) {
        const double x = 6 + 0.5 * i + random.uniform(-0.1, 0.1);
        const double y = 6 + 0.5 * j + random.uniform(-0.1, 0.1);
        const double r = std::hypot(x - 13, y - 13);
        cloud.push_back({x, y, 12 + 3 * std::exp(-r * r / 6)});
      }
    }
    const std::size_t count = cloud.size();
    for (std::size_t k = 0; k < count; ++k) cloud.push_back(cloud[k] + apart);
    surface = cloud_surface(cloud);
    overlap = overlapping_facets(model, surface.rim);
  }
};

TEST(OutwardNormals, FaceAsTheModelDoes) {
  ScannedTop scene({0, 0, 0});  // each sample twice
  for (int turned = 0; turned < 2; ++turned) {
    const std::vector<Vec3> normals =
        outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
    ASSERT_EQ(normals.size(), scene.cloud.size());
    std::size_t known = 0;
    for (const Vec3& n : normals) {
      if (n == Vec3{}) continue;
      ++known;
      EXPECT_GT(n.z, 0.3);
      EXPECT_NEAR(norm(n), 1, 1e-12);
    }
    EXPECT_GE(known, scene.cloud.size() / 2 - 20);
    EXPECT_LE(known, scene.cloud.size() / 2);
    for (Triangle& t : scene.surface.mesh.triangles) std::swap(t[1], t[2]);
  }
}

// A part without a loop on the model faces away from it where it hangs outside. Inside, as the
// floor of a pocket may, it does not tell: the nearest side of the body may be the other one.
TEST(OutwardNormals, PartsWithoutALoopOnTheModelFaceAwayIfTheyAreOutside) {
  for (const double apart : {20.0, -25.0, -6.0}) {
    const ScannedTop scene({0, 0, apart});
    const std::vector<Vec3> normals =
        outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
    const auto is_known = [](const Vec3& n) { return n != Vec3{}; };
    const auto half = normals.begin() + static_cast<std::ptrdiff_t>(normals.size() / 2);
    EXPECT_GT(std::count_if(normals.begin(), half, is_known), 800) << apart;
    const auto others = std::count_if(half, normals.end(), is_known);
    if (apart == -6) {
      EXPECT_EQ(others, 0);
    } else {
      EXPECT_GT(others, 800) << apart;
    }
    for (auto n = half; n != normals.end(); ++n) {
      if (is_known(*n)) {
        EXPECT_GT(apart * n->z, 0) << apart;
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
