#include "update/checks/contradicted_samples.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "update/cloud/samples_with_flag.h"

namespace cocoon {
namespace {

// A row of samples one unit apart.
std::vector<Point> row(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({static_cast<double>(i), 0, 0});
  return points;
}

TEST(ContradictedSamples, AreTheyMany) {
  const std::vector<Point> samples = row(2001);
  const auto found = [&](std::size_t of, std::size_t count) {
    return contradicted_samples({Points(samples).first(of), 1}, Points(samples).first(count));
  };
  EXPECT_EQ(found(500, 7).count, 7U);
  EXPECT_EQ(found(500, 7).of, 500U);
  EXPECT_FALSE(found(500, 9).is_doubtful({}));
  EXPECT_TRUE(found(500, 10).is_doubtful({}));
  EXPECT_TRUE(found(2000, 20).is_doubtful({}));
  EXPECT_FALSE(found(2001, 20).is_doubtful({}));
  EXPECT_FALSE(found(500, 0).is_doubtful({}));
}

// Twelve alone, and five in a cross that all see each other; the order does not matter.
TEST(ContradictedSamples, ThePlaceIsWhereMostAre) {
  std::vector<Point> places;
  for (const Point& p : row(12)) places.push_back(10.0 * p);
  const std::vector<Point> cross = {
      {50, 20, 0}, {49, 20, 0}, {51, 20, 0}, {50, 21, 0}, {50, 19, 0}};
  places.insert(places.end(), cross.begin(), cross.end());
  const std::vector<Point> samples = row(200);
  const Scan scan{samples, 1};
  EXPECT_EQ(contradicted_samples(scan, places, {.reach = 1.1}).at, (Point{50, 20, 0}));
  EXPECT_EQ(contradicted_samples(scan, places).at, (Point{49, 20, 0}));
  std::reverse(places.begin(), places.end());
  EXPECT_EQ(contradicted_samples(scan, places).at, (Point{49, 20, 0}));
  EXPECT_EQ(contradicted_samples({samples, 0.5}, places, {.reach = 2.2}).at, (Point{50, 20, 0}));
}

// Two clouds joined and one alone; a sample that comes twice is told once, by the first.
TEST(ContradictedSamples, AreToldOfEachCloud) {
  Replacement replacement;
  const auto positions = [](const std::vector<std::uint32_t>& at) {
    IdVector<PointId, PointId> ids;
    for (const std::uint32_t p : at) ids.push_back(PointId(p));
    return ids;
  };
  replacement.points.resize(6);
  replacement.point_of_cloud_point = {positions({1, 2}), positions({2, 3, 4}), positions({4, 5})};
  const std::vector<std::vector<Point>> clouds = {row(2), row(3), row(2)};
  const std::vector<JoinedCloud> joined = {{.members = {0, 2}, .sheet = {}},
                                           {.members = {1}, .sheet = {}}};
  const IdVector<PointId, std::uint8_t> flags(std::vector<std::uint8_t>{1, 0, 1, 0, 1, 1});
  const std::vector<std::vector<Point>> found =
      samples_with_flag(replacement, joined, clouds, flags);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], (std::vector<Point>{clouds[0][1], clouds[2][0], clouds[2][1]}));
  EXPECT_TRUE(found[1].empty());
  replacement.point_of_cloud_point[2][PointId(0)] = {};  // left out: then by the other cloud
  EXPECT_EQ(samples_with_flag(replacement, joined, clouds, flags)[1],
            (std::vector<Point>{clouds[1][2]}));
}

}  // namespace
}  // namespace cocoon
