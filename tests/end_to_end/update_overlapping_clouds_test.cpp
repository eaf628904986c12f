// A pocket with sharp edges in a slab, scanned by two clouds that overlap each other in it. The
// surface of each is torn along the edges, and ends in the midst of the other one.
#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "tests/end_to_end/local_update.h"
#include "tests/end_to_end/slab_with_pocket.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::Clouds;
using testing::SlabWithPocket;

Clouds two_halves(SlabWithPocket& slab) {
  Clouds clouds(2);
  for (const Point& p : slab.scan()) {
    if (p.x < 14) clouds[0].push_back(p);
  }
  for (const Point& p : slab.scan()) {
    if (p.x > 11) clouds[1].push_back(p);
  }
  return clouds;
}

// How many clouds are told to end on what has changed.
std::ptrdiff_t doubtful_ends(const UpdateResult& result) {
  return std::count_if(result.clouds.begin(), result.clouds.end(),
                       [](const CloudReport& cloud) { return cloud.surface.rim.leaves_model; });
}

// What is wrong with the caller's own part, or the model, is no reason to take clouds apart.
TEST(UpdateOfJoinedClouds, TakesThemApartForNoOtherError) {
  SlabWithPocket slab(1);
  int calls = 0;
  UpdateParts parts;
  parts.index = [&](const Execution&) -> const ModelIndex& {
    ++calls;
    throw InputError("no index");
  };
  EXPECT_THROW(update_model(slab.model, two_halves(slab), parts), InputError);
  EXPECT_EQ(calls, 1);
}

// Of samples along a line and a few beside it, which do span space, those on the line are chosen.
TEST(UpdateOfJoinedClouds, GoesOnWithCloudsApartIfFewOfTheirSamplesSpanNoSpace) {
  const SlabWithPocket slab(1);
  Clouds clouds(2);
  for (std::size_t c = 0; c < 2; ++c) {
    for (int i = 0; i < 12; ++i) {
      const Point p = {i + 0.05 * static_cast<double>(c), 10, 30};
      clouds[c].push_back(p);
      if (i % 4 == 1) clouds[c].push_back(p + Vec3{0.2, 0.1, 0.05 * i});
    }
  }
  ASSERT_FALSE(join_clouds(clouds).empty());
  const UpdateResult result = update_model(slab.model, clouds);
  EXPECT_EQ(result.status, UpdateStatus::no_cloud_surface);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings[0].find("do not make one surface"), std::string::npos);
  EXPECT_NE(result.warnings[0].find("all points lie on one line"), std::string::npos);
}

class UpdateOverlappingClouds : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(UpdateOverlappingClouds, AreOneSurface) {
  SlabWithPocket part(GetParam());
  const Clouds clouds = two_halves(part);
  const UpdateResult result = update_model(part.model, clouds);
  testing::expect_local_update(part.model, clouds, result, SlabWithPocket::in_pocket,
                               SlabWithPocket::is_far);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_EQ(result.clouds[1].joined_with, 0U);
}

TEST_P(UpdateOverlappingClouds, EndWhereAllOfThemEnd) {
  SlabWithPocket part(GetParam());
  const Clouds clouds = two_halves(part);
  UpdateOptions apart;
  apart.join.reach = 0;
  const UpdateResult result = update_model(part.model, clouds, apart);
  testing::expect_local_update(part.model, clouds, result, SlabWithPocket::in_pocket,
                               SlabWithPocket::is_far);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_GT(result.clouds[1].surface.rim.seam_edges, 0U);  // torn
  for (const CloudReport& cloud : result.clouds) EXPECT_GT(cloud.surface.rim.shared_edges, 5U);

  // Of each by itself the end in the midst of the other one is a doubtful one.
  UpdateOptions alone = apart;
  alone.shared.reach = 0;
  EXPECT_EQ(doubtful_ends(update_model(part.model, clouds, alone)), 2);
  EXPECT_LT(doubtful_ends(result), 2);
}

// Above the model: each ends in the midst of the other one, but nothing ties them to the model. Nor
// does a cloud elsewhere that is where it should be.
TEST_P(UpdateOverlappingClouds, AreRefusedOffTheModel) {
  SlabWithPocket part(GetParam());
  Clouds off = two_halves(part);
  for (std::vector<Point>& cloud : off) {
    for (Point& p : cloud) p.z += 40;
  }
  EXPECT_EQ(update_model(part.model, off).status, UpdateStatus::no_overlap);
  off.push_back(part.scan());
  EXPECT_EQ(update_model(part.model, off).status, UpdateStatus::no_overlap);
  EXPECT_EQ(update_model(part.model, Clouds{off[0], off[0]}).status, UpdateStatus::no_overlap);
}

INSTANTIATE_TEST_SUITE_P(Scans, UpdateOverlappingClouds, ::testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace cocoon
