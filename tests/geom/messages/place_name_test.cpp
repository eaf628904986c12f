#include "geom/messages/place_name.h"

#include <gtest/gtest.h>
#include <limits>

namespace cocoon {
namespace {

TEST(PlaceName, SixDigitsAndThreeBehindThePoint) {
  EXPECT_EQ(place_name({1.5, -2, 1.0 / 3}), "(1.5, -2, 0.333333)");
  EXPECT_EQ(place_name({999.5, -1000.0625, 1e-7 / 3}), "(999.5, -1000.062, 3.33333e-08)");
  EXPECT_EQ(place_name({500000.12, 5403780.3, 99.6071}), "(500000.12, 5403780.3, 99.6071)");
  EXPECT_EQ(place_name({5403780.2254, -1e12 - 0.25, 0}), "(5403780.225, -1000000000000.25, 0)");
  EXPECT_EQ(place_name({1e300, -0.0, 5e-324}), "(1e+300, -0, 4.94066e-324)");
}

TEST(PlaceName, NoNumbers) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(place_name({infinite, -infinite, 0}), "(inf, -inf, 0)");
}

}  // namespace
}  // namespace cocoon
