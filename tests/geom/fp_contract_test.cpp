// The error bounds of the filters count one rounding per operation, and results must be the same
// on every machine. A compiler that contracts a * b + c to a fused multiply-add breaks both; it
// does so without being asked unless -ffp-contract=off is given.
#include <cmath>
#include <gtest/gtest.h>

#include "geom/point.h"

namespace cocoon {
namespace {

// (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60: the last term is lost in a rounded product, so that
// a * a - rounded(a * a) is 0 without contraction and 2^-60 with it.
constexpr double kFactor = 1 + 0x1p-30;
constexpr double kRounded = 1 + 0x1p-29;

volatile double factor = kFactor;
volatile double rounded_square = kRounded;

double plain(double a, double c) { return a * a - c; }

TEST(FpContract, ExampleTellsFusedFromPlain) {
  EXPECT_EQ(std::fma(kFactor, kFactor, -kRounded), 0x1p-60);
}

TEST(FpContract, ProductsAreRoundedInThisBuild) { EXPECT_EQ(plain(factor, rounded_square), 0); }

// In the header's own expressions: one product of dot and of cross exactly cancels the other.
TEST(FpContract, ProductsOfPointHeaderAreRounded) {
  const double a = factor;
  const double c = rounded_square;
  EXPECT_EQ(dot({a, -1, 0}, {a, c, 0}), 0);
  EXPECT_EQ(cross({a, c, 0}, {1, a, 0}).z, 0);
}

#if (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__)
// The same with the instruction set that has fused multiply-add: fails when the flag is missing,
// also where the rest of the build does not use these instructions.
__attribute__((target("fma"), noinline)) double with_fused_instructions(double a, double c) {
  return a * a - c;
}

TEST(FpContract, ProductsAreRoundedWhereFusedInstructionsExist) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  EXPECT_EQ(with_fused_instructions(factor, rounded_square), 0) << "is -ffp-contract=off set?";
}
#endif

}  // namespace
}  // namespace cocoon
