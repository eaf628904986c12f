#include "update/checks/unexplained_handles.h"

#include <gtest/gtest.h>
#include <vector>

namespace cocoon {
namespace {

TEST(UnexplainedHandles, APatchForTwoPartsMakesOneHandle) {
  const std::vector<SewnPatch> patch = {SewnPatch{1, 1}};
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 0), 1U);
  const std::vector<SewnPatch> drill = {SewnPatch{2, 2}};
  EXPECT_EQ(unexplained_handles(drill, 0, 2, 0), 0U);
  EXPECT_EQ(unexplained_handles(drill, 0, 2, -4), 2U);
  EXPECT_EQ(unexplained_handles(drill, 0, 0, 2), 0U);  // a handle goes
  const std::vector<SewnPatch> several = {SewnPatch{2, 2}, SewnPatch{3, 3}, SewnPatch{0, 0}};
  EXPECT_EQ(unexplained_handles(several, 0, 2, -4), 0U);
  EXPECT_EQ(unexplained_handles(several, 0, 2, -6), 1U);
}

// A tube has two rims, and so has what is left of the model around it.
TEST(UnexplainedHandles, TwoRimsOfOnePartMakeNone) {
  const std::vector<SewnPatch> tube = {SewnPatch{2, 1}};
  EXPECT_EQ(unexplained_handles(tube, 0, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(tube, 0, 2, 0), 1U);
}

// A border that touches itself parts slivers from what it encloses.
TEST(UnexplainedHandles, MorePartsThanRimsMakeNone) {
  const std::vector<SewnPatch> patch = {SewnPatch{1, 3}};
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 0), 1U);
  // A part and a sliver at one rim, nothing inside the other.
  const std::vector<SewnPatch> drill = {SewnPatch{2, 2}};
  EXPECT_EQ(unexplained_handles(drill, 1, 2, 0), 0U);
  EXPECT_EQ(unexplained_handles(drill, 1, 2, -2), 1U);
}

TEST(UnexplainedHandles, AMouthMayHaveNoGroupInside) {
  const std::vector<SewnPatch> drill = {SewnPatch{2, 1}};
  EXPECT_EQ(unexplained_handles(drill, 1, 2, 0), 0U);
  EXPECT_EQ(unexplained_handles(drill, 1, 2, -2), 1U);
  const std::vector<SewnPatch> patch = {SewnPatch{1, 0}};
  EXPECT_EQ(unexplained_handles(patch, 1, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(patch, 1, 2, 0), 1U);
}

}  // namespace
}  // namespace cocoon
