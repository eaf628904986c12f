#include "update/checks/unexplained_handles.h"

#include <gtest/gtest.h>
#include <vector>

namespace cocoon {
namespace {

// A cloud with that many loops on the model, a pin-hole there, and a loop off it, in the place of
// so many parts.
CloudReport cloud_with(std::size_t loops, std::size_t parts) {
  CloudReport cloud;
  for (std::size_t p = 0; p < parts; ++p) cloud.replaced_groups.push_back(RegionId(p + 1));
  cloud.loops.resize(loops + 2);
  for (std::size_t l = 0; l <= loops; ++l) cloud.loops[l].match = LoopMatch::on_model;
  cloud.loops[loops].pin_hole = true;
  return cloud;
}

TEST(UnexplainedHandles, APatchForTwoPartsMakesOneHandle) {
  const std::vector<CloudReport> patch = {cloud_with(1, 1)};
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 0), 1U);
  const std::vector<CloudReport> drill = {cloud_with(2, 2)};
  EXPECT_EQ(unexplained_handles(drill, 0, 2, 0), 0U);
  EXPECT_EQ(unexplained_handles(drill, 0, 2, -4), 2U);
  EXPECT_EQ(unexplained_handles(drill, 0, 0, 2), 0U);  // a handle goes
  const std::vector<CloudReport> several = {cloud_with(2, 2), cloud_with(3, 3), cloud_with(0, 0)};
  EXPECT_EQ(unexplained_handles(several, 0, 2, -4), 0U);
  EXPECT_EQ(unexplained_handles(several, 0, 2, -6), 1U);
}

// A tube has two rims, and so has what is left of the model around it.
TEST(UnexplainedHandles, TwoRimsOfOnePartMakeNone) {
  const std::vector<CloudReport> tube = {cloud_with(2, 1)};
  EXPECT_EQ(unexplained_handles(tube, 0, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(tube, 0, 2, 0), 1U);
}

// A border that touches itself parts slivers from what it encloses.
TEST(UnexplainedHandles, MorePartsThanRimsMakeNone) {
  const std::vector<CloudReport> patch = {cloud_with(1, 3)};
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(patch, 0, 2, 0), 1U);
  // A part and a sliver at one rim, nothing inside the other.
  const std::vector<CloudReport> drill = {cloud_with(2, 2)};
  EXPECT_EQ(unexplained_handles(drill, 1, 2, 0), 0U);
  EXPECT_EQ(unexplained_handles(drill, 1, 2, -2), 1U);
}

TEST(UnexplainedHandles, AMouthMayHaveNoGroupInside) {
  const std::vector<CloudReport> drill = {cloud_with(2, 1)};
  EXPECT_EQ(unexplained_handles(drill, 1, 2, 0), 0U);
  EXPECT_EQ(unexplained_handles(drill, 1, 2, -2), 1U);
  const std::vector<CloudReport> patch = {cloud_with(1, 0)};
  EXPECT_EQ(unexplained_handles(patch, 1, 2, 2), 0U);
  EXPECT_EQ(unexplained_handles(patch, 1, 2, 0), 1U);
}

// A torn scan may have lost the rim at the other mouth. Most results in which one is missing are
// wrong somewhere.
TEST(UnexplainedHandles, ATornSurfaceExplainsNone) {
  std::vector<CloudReport> drill = {cloud_with(1, 1)};
  drill[0].surface.rim.seam_edges = 3;
  EXPECT_EQ(unexplained_handles(drill, 0, 2, 0), 1U);
}

}  // namespace
}  // namespace cocoon
