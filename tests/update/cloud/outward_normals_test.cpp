#include "update/cloud/outward_normals.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A block, and a scan of its top, which is at z = 6, with a hill; what is below z = 0 is the end of
// another thing beside it.
struct ScannedTop {
  TriangleMesh block = testing::block(20, 20, 6);
  ModelIndex model{block};
  std::vector<Point> cloud;
  CloudSurface surface;
  Overlap overlap;

  explicit ScannedTop(const Vec3& apart) {
    Random random(5);
    for (int i = 0; i < 29; ++i) {
      for (int j = 0; j < 29; ++j) {
        const double x = 3 + 0.5 * i + random.uniform(-0.1, 0.1);
        const double y = 3 + 0.5 * j + random.uniform(-0.1, 0.1);
        const double r = std::hypot(x - 10, y - 10);
        cloud.push_back({x, y, 6 + 3 * std::exp(-r * r / 6)});
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

TEST(OutwardNormals, AreNotKnownOfPartsWithoutALoopOnTheModel) {
  const ScannedTop scene({0, 0, 20});
  const std::vector<Vec3> normals =
      outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
  const auto is_known = [](const Vec3& n) { return n != Vec3{}; };
  const auto half = normals.begin() + static_cast<std::ptrdiff_t>(normals.size() / 2);
  EXPECT_GT(std::count_if(normals.begin(), half, is_known), 800);
  EXPECT_EQ(std::count_if(half, normals.end(), is_known), 0);
}

}  // namespace
}  // namespace cocoon
