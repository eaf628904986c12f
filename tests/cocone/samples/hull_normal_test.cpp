#include "cocone/samples/hull_normal.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(HullNormal, CancelingNormalsAreDegenerate) {
  // The rim of a nearly flat patch: hull facets above and below.
  std::vector<Vec3> directions{unit({0.01, 0, 1}), unit({0.01, 0, -1})};
  const HullNormal result = hull_normal(directions);
  EXPECT_TRUE(result.degenerate);
  EXPECT_GT(std::abs(result.normal.z), 0.999);
  std::vector<Vec3> agreeing{unit({0.1, 0, 1}), unit({-0.1, 0, 1})};
  EXPECT_FALSE(hull_normal(agreeing).degenerate);
}

TEST(HullNormal, DoesNotDependOnOrder) {
  Random random(17);
  std::vector<Vec3> directions;
  for (int i = 0; i < 9; ++i) directions.push_back(random.on_unit_sphere() + Vec3{0, 0, 1.5});
  for (Vec3& d : directions) d = unit(d);
  const Vec3 expected = hull_normal(directions).normal;
  for (int i = 0; i < 20; ++i) {
    random.shuffle(directions);
    EXPECT_EQ(hull_normal(directions).normal, expected);
  }
}

}  // namespace
}  // namespace cocoon
