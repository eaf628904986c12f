#include "update/rim_doubt.h"

#include <gtest/gtest.h>
#include <numbers>

#include "tests/update/hand_made_models.h"
#include "tests/update/torn_rims.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::grid_plane;
using testing::inside_out;
using testing::middle;
using testing::radius;
using testing::rim_of;
using testing::torn_rim;

RimDoubt doubt_of(const CloudRim& rim, const CutOptions& options = {}) {
  const TriangleMesh mesh = grid_plane(30);
  const ModelIndex model(mesh);
  return rim_doubt(model, rim.loops[0].points, rim, overlapping_facets(model, rim), {}, options);
}

TEST(RimDoubt, AWholeRimLeavesNone) {
  const RimDoubt doubt = doubt_of(torn_rim(0, 0));
  EXPECT_EQ(doubt.share, 0);
  // The smaller side of a border of facets along the circle.
  EXPECT_GT(doubt.told, 2 * std::numbers::pi * (radius - 1.5));
  EXPECT_LT(doubt.told, 4 / std::numbers::pi * 2 * std::numbers::pi * radius);
}

TEST(RimDoubt, TheMoreIsMissingTheMoreIsInDoubt) {
  const RimDoubt some = doubt_of(torn_rim(20, 30));
  const RimDoubt more = doubt_of(torn_rim(20, 42));
  EXPECT_GT(some.share, 0);
  EXPECT_GT(more.share, some.share);
  EXPECT_LT(more.told, some.told);
}

TEST(RimDoubt, TellsWhetherFacetsGoFarFromTheSamples) {
  EXPECT_FALSE(doubt_of(torn_rim(0, 0)).reaches_far);
  EXPECT_TRUE(doubt_of(inside_out(torn_rim(0, 0))).reaches_far);
  EXPECT_FALSE(doubt_of(inside_out(torn_rim(0, 0)), {.box_reach = 100}).reaches_far);
}

TEST(RimDoubt, OfNothingAllIsInDoubt) {
  const RimDoubt seam = doubt_of(torn_rim(0, 60));
  EXPECT_EQ(seam.share, 1);
  EXPECT_EQ(seam.told, 0);
  CloudRim off = torn_rim(0, 0);
  for (Point& p : off.loops[0].points) p.z += 100;
  EXPECT_EQ(doubt_of(off).share, 1);
}

// A loop that is not on the model is not there.
TEST(RimDoubt, LoopsOffTheModelHaveNoPartInIt) {
  CloudRim rim = torn_rim(20, 30);
  const RimDoubt alone = doubt_of(rim);
  RimLoop off = rim_of({circle(20, {15, 15, 40}, 3)}).loops[0];
  off.inner.assign(off.size(), 0);
  rim.loops.push_back(off);
  const RimDoubt both = doubt_of(rim);
  EXPECT_EQ(both.share, alone.share);
  EXPECT_EQ(both.told, alone.told);
}

}  // namespace
}  // namespace cocoon
