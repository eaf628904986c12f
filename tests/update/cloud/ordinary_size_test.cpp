#include "update/cloud/ordinary_size.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

using Clouds = std::vector<std::vector<Point>>;

// Empty if nothing is wrong.
std::string message_of(const std::vector<Point>& model, const Clouds& clouds) {
  try {
    require_ordinary_size(Points(model), clouds);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(OrdinarySize, HasRoomForProductsOfThreeLengths) {
  const std::vector<Point> model = {{0, 0, 1}};
  EXPECT_EQ(message_of(model, {}), "");
  EXPECT_EQ(message_of(model, {{{0, 0, 0}}, {{0x1p+200, 0, 0}, {0, -0x1p-200, 0}}}), "");
  EXPECT_EQ(message_of({}, {{{0x1p-200, 0, 0}}, {}}), "");
  EXPECT_EQ(message_of({{0x1p+201, 0, 0}}, {}).find("the model: its largest"), 0U);
  EXPECT_EQ(message_of(model, {{{1, 1, 1}}, {{0, -0x1p+201, 0}}}).find("cloud 2 of 2: its"), 0U);
  EXPECT_EQ(message_of(model, {{{0, 0x1p-201, 0}}}).find("cloud 1 of 1: its largest"), 0U);
}

TEST(OrdinarySize, IsThatOfFiniteCloudsOnly) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message_of({}, {{{1, 2, 3}}, {{1, 1, 1}, {0, nan, 0}}}).find("cloud 2 of 2: point 1 "),
            0U);
  EXPECT_EQ(message_of({}, {{{0, 0, -infinity}}}).find("cloud 1 of 1: point 0 "), 0U);
}

TEST(OrdinarySize, IsThatOfMostPointsOfACloud) {
  EXPECT_EQ(message_of({}, {{{1, 1, 1}, {0, 1e-250, 0}}}), "");
  EXPECT_EQ(
      message_of({}, {{{1e-250, 0, 0}, {0, 1e-250, 0}, {1, 1, 1}}}).find("cloud 1 of 1: point 2 "),
      0U);
}

}  // namespace
}  // namespace cocoon
