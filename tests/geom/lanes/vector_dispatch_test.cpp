#include "geom/lanes/vector_dispatch.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

// The better a set, the lower its bit.
std::int64_t best_of(std::int64_t sets) { return sets & -sets; }

TEST(VectorDispatch, SeesTheProcessorAsHighwayDoes) {
  const std::int64_t expected = hwy::SupportedTargets() & HWY_TARGETS;
  EXPECT_NE(instruction_sets(), 0);
  EXPECT_EQ(instruction_sets() & ~expected, 0) << "more than there are";
  EXPECT_STREQ(hwy::TargetName(best_of(instruction_sets())), hwy::TargetName(best_of(expected)));
}

}  // namespace
}  // namespace cocoon
