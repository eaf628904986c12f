#include "geom/messages/require_number.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "geom/errors.h"

namespace cocoon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusal(double value, double low, double high) {
  try {
    require_number("some_stage", "some_option", value, low, high);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(RequireNumber, TakesWhatIsInRange) {
  EXPECT_EQ(refusal(0, 0, 1), "");
  EXPECT_EQ(refusal(1, 0, 1), "");
  EXPECT_EQ(refusal(infinity, 0, infinity), "");
  EXPECT_EQ(refusal(-infinity, -infinity, infinity), "");
}

TEST(RequireNumber, SaysWhatIsWrongAndWhatToGive) {
  EXPECT_EQ(refusal(5, 0, 1), "some_stage: the option some_option is 5; give a number from 0 to 1");
  EXPECT_EQ(refusal(-0.5, 0, infinity),
            "some_stage: the option some_option is -0.5; give a number of at least 0");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(nan, -infinity, infinity),
            "some_stage: the option some_option is nan; give a number");
}

}  // namespace
}  // namespace cocoon
