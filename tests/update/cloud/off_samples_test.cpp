#include "update/cloud/off_samples.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

TEST(OffSamples, AreThoseFartherAwayInTheirOrder) {
  const TriangleMesh block = testing::block(4, 4, 4);
  const ModelIndex model(block);
  const std::vector<Point> samples = {{2, 2, 7}, {2, 2, 4.5}, {2, 2, 2}, {-3, 2, 2}};
  const std::vector<Outward> outward = {{{0, 0, 1}}, {{0, 1, 0}}, {{1, 0, 0}}, {{-1, 0, 0}}};
  const std::vector<OffSample> off = outward_samples_off_model(model, samples, outward, 1);
  ASSERT_EQ(off.size(), 3U);
  for (std::size_t k = 0; k < off.size(); ++k) {
    const std::size_t sample = k == 0 ? 0 : k + 1;
    EXPECT_EQ(off[k].place, samples[sample]);
    EXPECT_EQ(off[k].outward, outward[sample]);
  }
  const std::vector<OffSample> unknown = outward_samples_off_model(model, samples, {}, 2.5);
  ASSERT_EQ(unknown.size(), 2U);
  EXPECT_EQ(unknown[1].place, samples[3]);
  EXPECT_EQ(unknown[1].outward, Outward{});
  const std::vector<Outward> few(2);
  EXPECT_THROW(outward_samples_off_model(model, samples, few, 1), InputError);
}

}  // namespace
}  // namespace cocoon
