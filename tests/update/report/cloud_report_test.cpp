#include "update/report/cloud_report.h"

#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace cocoon {
namespace {

TEST(CloudReport, LoopsThatAreNoBorderHaveNoRimThere) {
  std::vector<CloudReport> clouds(1);
  for (const LoopMatch match : {LoopMatch::on_model, LoopMatch::covered, LoopMatch::off_model}) {
    clouds[0].loops.emplace_back().match = match;
    clouds[0].surface.rim.loops.emplace_back().points = {{1, 2, 3}};
  }
  const std::vector<CloudRim> rims = border_rims_of(clouds);
  ASSERT_EQ(rims[0].loops.size(), 3U);
  EXPECT_EQ(rims[0].loops[0].size(), 1U);
  EXPECT_EQ(rims[0].loops[1].size(), 0U);
  EXPECT_EQ(rims[0].loops[2].size(), 0U);
}

// Clouds 1 and 3 were joined; cloud 2 lies between them.
TEST(CloudReport, APointOfJoinedCloudsIsToldByItsOwn) {
  const std::vector<std::vector<Point>> clouds = {{{}}, {{}, {}, {}}, {{}, {}}, {{}, {}}};
  std::vector<CloudReport> reports(4);
  reports[3].joined_with = 1;
  const auto told = [&](std::uint32_t p) {
    const CloudPoint point = point_told(reports, clouds, 1, PointId(p));
    return std::vector{point.cloud, point.index};
  };
  EXPECT_EQ(told(2), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(told(3), (std::vector<std::size_t>{3, 0}));
  EXPECT_EQ(told(4), (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(members_told(reports, 1), (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(members_told(reports, 2), (std::vector<std::size_t>{2}));
}

TEST(CloudReport, MembersHaveTheSpacingAndTheRegionsOfTheirFirst) {
  std::vector<CloudReport> reports(1);
  reports[0].surface.rim.spacing = 2;
  reports[0].believed_shift = {1, 0, 0};
  reports[0].groups = {{RegionId(0U), 10, 5, true}};
  reports[0].replaced_groups = {RegionId(0U)};
  const std::vector<JoinedCloud> joined = {{.members = {0, 1}, .sheet = {}}};
  const std::vector<CloudReport> told = reports_of_members(reports, joined, 2);
  EXPECT_EQ(told[1].surface.rim.spacing, 2);
  EXPECT_EQ(told[1].believed_shift, (Vec3{1, 0, 0}));
  EXPECT_EQ(told[1].groups.size(), 1U);
  EXPECT_EQ(told[1].replaced_groups, std::vector{RegionId(0U)});
}

// What is longer than a shift that is worth a warning may be of the change.
TEST(CloudReport, ALongShiftIsToldButNotBelieved) {
  CloudReport report;
  report.surface.rim.spacing = 2;
  enter_shift({0, 3, 0}, {.max_shift = 1.5}, report);
  EXPECT_EQ(report.shift, 3);
  EXPECT_EQ(report.believed_shift, (Vec3{0, 3, 0}));
  enter_shift({0, 3.1, 0}, {.max_shift = 1.5}, report);
  EXPECT_EQ(report.shift, 3.1);
  EXPECT_EQ(report.believed_shift, Vec3());
}

// Joined ones are told what is of both.
TEST(CloudReport, OfAMemberHasWhatToldItsSides) {
  std::vector<CloudReport> reports(1);
  reports[0].is_told_by_samples = true;
  reports[0].is_told_by_sure_angles = true;
  const std::vector<JoinedCloud> joined = {{.members = {0, 1}, .sheet = {}}};
  const std::vector<CloudReport> members = reports_of_members(reports, joined, 2);
  EXPECT_EQ(members[1].joined_with, 0U);
  EXPECT_TRUE(members[1].is_told_by_samples);
  EXPECT_TRUE(members[1].is_told_by_sure_angles);
}

TEST(CloudReport, HasWhatTheStagesFound) {
  CloudReport report;
  report.loops.resize(1);
  Overlap overlap;
  overlap.figures.star_misses = 1;
  overlap.figures.largest_excess = 5;
  overlap.loops.resize(1);
  overlap.loops[0].unmatched = 7;
  overlap.loops[0].covered = 6;
  enter_overlap(overlap, report);
  EXPECT_EQ(report.overlap.star_misses, 1U);
  EXPECT_EQ(report.overlap.largest_excess, 5);
  EXPECT_EQ(report.loops[0].unmatched, 7U);
  EXPECT_EQ(report.loops[0].covered, 6U);
}

// Neither pin-holes nor loops off the model are rims of the patch.
TEST(CloudReport, TellsWhatWasPutIntoTheModel) {
  CloudReport report;
  report.loops.resize(4);
  for (std::size_t l = 0; l < 3; ++l) report.loops[l].match = LoopMatch::on_model;
  report.loops[2].pin_hole = true;
  report.replaced_groups = {RegionId(1U), RegionId(2U), RegionId(3U)};
  const std::vector<SewnPatch> patches = patches_of(std::vector{report, CloudReport{}});
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_EQ(patches[0].rims, 2U);
  EXPECT_EQ(patches[0].parts, 3U);
  EXPECT_EQ(patches[1].rims, 0U);
  EXPECT_EQ(patches[1].parts, 0U);
}

TEST(CloudReport, TellsAnglesInDegrees) {
  CloudChoice choice;
  choice.margin = std::numbers::pi / 4;
  choice.regions = {{RegionId(0U), std::numbers::pi, 5, false},
                    {RegionId(1U), std::numbers::pi / 2, 3, true}};
  CloudReport report;
  enter_choice(choice, report);
  EXPECT_NEAR(report.margin_deg, 45, 1e-12);
  ASSERT_EQ(report.groups.size(), 2U);
  EXPECT_NEAR(report.groups[1].mean_angle_deg(), 90, 1e-12);
  EXPECT_EQ(report.replaced_groups, std::vector{RegionId(1U)});
}

}  // namespace
}  // namespace cocoon
