#include "app/files/carried_properties.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace cocoon::app {
namespace {

TEST(CarriedProperties, OfSamplesAreThoseOfTheNearestVertex) {
  const std::array<double, 3> values = {5, 6, 7};
  const VertexProperties table{3, {property_of("height", values)}, {"a, why"}};
  const std::vector<Point> samples = {
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.9, 0.2, 0}, {0.1, 0.8, 0}};
  const std::array<double, 5> expected = {5, 6, 7, 6, 7};
  EXPECT_EQ(properties_of_samples(table, samples),
            (VertexProperties{5, {property_of("height", expected)}, {"a, why"}}));
}

TEST(CarriedProperties, OfSamplesAreNoneIfTheMeshHasNone) {
  EXPECT_EQ(properties_of_samples({}, std::vector<Point>(4)), (VertexProperties{4, {}, {}}));
}

}  // namespace
}  // namespace cocoon::app
