#include "geom/messages/rounded.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace cocoon {
namespace {

TEST(Rounded, SignificantDigitsWithoutZerosAtTheEnd) {
  EXPECT_EQ(rounded(0.3), "0.3");
  EXPECT_EQ(rounded(12.345), "12.35");
  EXPECT_EQ(rounded(-1.0 / 3), "-0.3333");
  EXPECT_EQ(rounded(123456), "1.235e+05");
  EXPECT_EQ(rounded(1.5e-7), "1.5e-07");
  EXPECT_EQ(rounded(0), "0");
  EXPECT_EQ(rounded(-std::numeric_limits<double>::max(), 17), "-1.7976931348623157e+308");
  EXPECT_EQ(rounded(HUGE_VAL), "inf");
}

}  // namespace
}  // namespace cocoon
