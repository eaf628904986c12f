#include "update/checks/unit_factor.h"

#include <gtest/gtest.h>
#include <optional>

#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

using testing::rim_of;

std::optional<double> factor_of(const TriangleMesh& model, const CloudRim& rim) {
  const ModelIndex index(model);
  return unit_factor(index, rim, overlapping_facets(index, rim));
}

TEST(UnitFactor, BringsTheRimToTheModel) {
  const TriangleMesh ball = testing::sphere(5);
  const CloudRim rim = rim_of({testing::cap_rim(40, {0, 0, 1}, 0.8)});
  for (const double factor : {10.0, 25.4, 1000.0, 0.1, 0.001}) {
    EXPECT_EQ(factor_of(ball, scaled(rim, 1 / factor)), factor);
  }
  EXPECT_EQ(factor_of(ball, scaled(rim, 0.2)), std::nullopt);
}

// Of two balls one about the other the rim lies on either.
TEST(UnitFactor, OfTwoThatAreAsFarFromOneIsTheLargerOne) {
  const TriangleMesh balls =
      gallery::join(testing::sphere(3), gallery::scaled(testing::sphere(6), 100));
  const CloudRim rim = rim_of({testing::cap_rim(30, {0, 0, 1}, 0.8)});
  EXPECT_EQ(factor_of(balls, scaled(rim, 10)), 10.0);
}

// A third as large the rim would lie on the plane; the denser one has a fiftieth of its edges then.
TEST(UnitFactor, MakesNoDotsOfTheSamples) {
  const TriangleMesh plane = testing::grid_plane(20);
  EXPECT_EQ(factor_of(plane, rim_of({testing::circle(20, {3, 3, 8}, 0.8)})), 0.3048);
  EXPECT_EQ(factor_of(plane, rim_of({testing::circle(80, {3, 3, 8}, 0.8)})), std::nullopt);
}

// The rim of a scan that ends on what has changed: a third as large all of it would be near enough.
TEST(UnitFactor, IsNotAskedForWhereSomeOfTheRimLiesOnTheModel) {
  const TriangleMesh plane = testing::grid_plane(20);
  RimLoop loop = testing::circle(20, {3, 3, 0}, 0.8);
  for (std::size_t i = 0; i < 7; ++i) loop.points[i].z = 8;
  EXPECT_EQ(factor_of(plane, rim_of({loop})), std::nullopt);
  for (std::size_t i = 7; i < 15; ++i) loop.points[i].z = 8;
  EXPECT_EQ(factor_of(plane, rim_of({loop})), std::nullopt);
  loop.points[15].z = 8;
  RimLoop torn = loop;  // what has cloud beyond it says nothing, on the model or off it
  torn.inner.assign(20, 0);
  for (std::size_t i = 16; i < 20; ++i) torn.inner[i] = 1;
  EXPECT_EQ(factor_of(plane, rim_of({torn})), 0.3048);
  EXPECT_EQ(factor_of(plane, rim_of({loop})), 0.3048);
}

}  // namespace
}  // namespace cocoon
