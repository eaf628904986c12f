#include "update/joined_clouds.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "update/report/cloud_report.h"

namespace cocoon {
namespace {

using Clouds = std::vector<std::vector<Point>>;

// Ten by ten samples, one apart.
std::vector<Point> square(const Vec3& at) {
  std::vector<Point> points;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      points.push_back(at + Vec3{static_cast<double>(x), static_cast<double>(y), 0});
    }
  }
  return points;
}

std::vector<std::vector<std::size_t>> members(const Clouds& clouds,
                                              const JoinOptions& options = {}) {
  std::vector<std::vector<std::size_t>> result;
  for (const JoinedCloud& joined : join_clouds(clouds, options)) result.push_back(joined.members);
  return result;
}

TEST(JoinedClouds, OverlapEachOther) {
  const Clouds clouds = {square({0, 0, 0}), square({40, 0, 0}), square({6.5, 0.5, 0.2}),
                         square({12.5, 1, 0})};
  const std::vector<std::vector<std::size_t>> expected = {{0, 2, 3}, {1}};
  EXPECT_EQ(members(clouds), expected);
  EXPECT_TRUE(members(clouds, {.reach = 0}).empty());
}

// One corner of one hundred samples; sheets farther apart than the samples of each.
TEST(JoinedClouds, DoNotIfTheyHardlyMeet) {
  EXPECT_TRUE(members({square({0, 0, 0}), square({10.2, 10.2, 0})}).empty());
  EXPECT_TRUE(members({square({0, 0, 0}), square({0.5, 0.5, 1.1})}).empty());
  EXPECT_FALSE(members({square({0, 0, 0}), square({0.5, 0.5, 0.6})}).empty());
}

// One sample of a hundred, at a corner, is near; a small dense cloud lies over a large one.
TEST(JoinedClouds, AreJoinedByTheShareOfEither) {
  EXPECT_TRUE(members({square({0, 0, 0}), square({9.5, 9.5, 0})}).empty());
  const std::vector<Point> dense = {{4.2, 4.2, 0.1}, {4.4, 4.4, 0.1}};
  EXPECT_FALSE(members({square({0, 0, 0}), dense}, {.min_share = 0.5}).empty());
  EXPECT_FALSE(members({dense, square({0, 0, 0})}, {.min_share = 0.5}).empty());
}

// In spacings of the coarsest one.
TEST(JoinedClouds, AreThinnedByTheLargestSpacing) {
  std::vector<Point> fine = square({0, 0, 0});
  for (Point& p : fine) p = 0.5 * p;
  const Clouds clouds = {square({0.1, 0.2, 0.1}), fine};
  const std::vector<JoinedCloud> joined = join_clouds(clouds);
  ASSERT_EQ(joined.size(), 1U);
  const std::vector<Point> samples = samples_of(joined[0], clouds);
  EXPECT_GE(joined[0].sheet.size(), 75U);  // of the coarse one, where nothing is beside it
  for (const PointId a : joined[0].sheet) {
    for (const PointId b : joined[0].sheet) {
      if (a == b) continue;
      EXPECT_GE(distance(samples[a.index()], samples[b.index()]), 0.7);
    }
  }
}

// A few samples of a scan that is there already make it no coarser; nor does a coarse scan of the
// same place. One that reaches beyond does.
TEST(JoinedClouds, OneThatLiesOnFinerOnesIsNotTheCoarsest) {
  const std::vector<Point> fine = square({0, 0, 0});
  const std::vector<Point> some = {fine[5], fine[44], fine[77]};
  const std::size_t all = join_clouds(Clouds{fine, some}).front().sheet.size();
  EXPECT_EQ(all, fine.size());
  EXPECT_EQ(join_clouds(Clouds{some, fine}).front().sheet.size(), all);
  EXPECT_LT(join_clouds(Clouds{fine, some}, {.coarser = 100}).front().sheet.size(), all / 2);
  EXPECT_EQ(join_clouds(Clouds{fine, fine}, {.coarser = 0}).front().sheet.size(), all);
  std::vector<Point> beyond = some;
  beyond.push_back({30, 4, 0});
  EXPECT_LT(join_clouds(Clouds{fine, beyond}).front().sheet.size(), all / 2);
}

// The sheet is without equal samples even where it takes all others.
TEST(JoinedClouds, WithoutThinningTheSheetHasDifferentSamples) {
  const Clouds clouds = {square({0, 0, 0}), square({5, 0, 0})};
  const JoinedCloud joined = join_clouds(clouds, {.thinning = 0}).front();
  EXPECT_EQ(joined.different, 150U);
  EXPECT_EQ(joined.sheet.size(), joined.different);
}

// Two samples come twice; thinned out are the others that are not on the sheet.
TEST(JoinedClouds, CountWhatIsSetAside) {
  Clouds clouds = {square({0, 0, 0}), square({5.1, 0.2, 0.1})};
  clouds[1].push_back(clouds[0][3]);
  clouds[1].push_back(clouds[1][3]);
  const JoinedCloud joined = join_clouds(clouds).front();
  const std::vector<Point> samples = samples_of(joined, clouds);
  const std::vector<CloudSurface> surfaces = joined_cloud_surfaces(samples, joined, {});
  EXPECT_EQ(surfaces[0].duplicates, 2U);
  EXPECT_EQ(surfaces[0].set_aside, 200U - joined.sheet.size());
}

TEST(JoinedClouds, KeepTheirDistanceOnTheSheet) {
  const Clouds clouds = {square({0, 0, 0}), square({5.1, 0.2, 0.1}), square({40, 0, 0})};
  const std::vector<JoinedCloud> joined = join_clouds(clouds);
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_TRUE(joined[1].sheet.empty());
  const std::vector<Point> samples = samples_of(joined[0], clouds);
  ASSERT_EQ(samples.size(), 200U);
  EXPECT_EQ(samples[100], clouds[1][0]);
  // Fifty of each lie beside the other one, the others are all there.
  EXPECT_EQ(joined[0].sheet.size(), 150U);
  EXPECT_EQ(joined[0].different, 200U);
  for (const PointId a : joined[0].sheet) {
    for (const PointId b : joined[0].sheet) {
      if (a == b) continue;
      EXPECT_GE(distance(samples[a.index()], samples[b.index()]), 0.7);
    }
  }
}

TEST(JoinedClouds, DoNotDependOnTheOrder) {
  Clouds clouds = {square({0, 0, 0}), square({5.1, 0.2, 0.1})};
  const auto sheet = [&] {
    const JoinedCloud joined = join_clouds(clouds).front();
    const std::vector<Point> samples = samples_of(joined, clouds);
    std::vector<Point> chosen;
    for (const PointId p : joined.sheet) chosen.push_back(samples[p.index()]);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  };
  const std::vector<Point> before = sheet();
  std::swap(clouds[0], clouds[1]);
  std::reverse(clouds[0].begin(), clouds[0].end());
  EXPECT_EQ(sheet(), before);
}

TEST(JoinedClouds, AreNoneThatCannotBeMeasured) {
  Clouds clouds = {square({0, 0, 0}), square({0.5, 0.5, 0}), {}, {{1, 1, 0}}};
  clouds[1][7].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(members(clouds).empty());
  EXPECT_TRUE(members({{{1, 1, 0}, {1, 1, 0}}, {{1, 1, 0}, {1, 1, 0}}}).empty());
}

TEST(JoinedClouds, AreReportedByTheFirst) {
  std::vector<CloudReport> reports(2);
  reports[0].boundary_points = 5;
  reports[1].boundary_points = 7;
  reports[1].margin_deg = 20;
  reports[1].surface.rim.median_edge = 3;
  const std::vector<JoinedCloud> joined = {{.members = {0}, .sheet = {}},
                                           {.members = {1, 2}, .sheet = {}}};
  const std::vector<CloudReport> told = reports_of_members(reports, joined, 3);
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(told[0].boundary_points, 5U);
  EXPECT_EQ(told[1].boundary_points, 7U);
  EXPECT_FALSE(told[1].joined_with);
  EXPECT_EQ(told[2].boundary_points, 0U);
  EXPECT_EQ(told[2].joined_with, 1U);
  EXPECT_EQ(told[2].margin_deg, 20);
  EXPECT_EQ(told[2].surface.rim.median_edge, 3);
}

}  // namespace
}  // namespace cocoon
