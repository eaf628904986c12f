#include "app/shapes/cloud_filter.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon::app {
namespace {

TEST(CloudFilter, OptionsAreThoseOfStraysButForWhatIsGiven) {
  CloudFilterArguments arguments;
  arguments.noise = NoiseHandling::none;
  EXPECT_FALSE(cloud_filter(arguments).strays.has_value());
  arguments.noise = NoiseHandling::robust;
  const StrayOptions usual = cloud_filter(arguments).strays.value();
  EXPECT_EQ(usual.neighbors, StrayOptions{}.neighbors);
  EXPECT_EQ(usual.outlier_ratio, StrayOptions{}.outlier_ratio);
  arguments.thresholds = {{"noise-neighbors", 5}, {"noise-outlier-ratio", 7.5}};
  const StrayOptions given = cloud_filter(arguments).strays.value();
  EXPECT_EQ(given.neighbors, 5U);
  EXPECT_EQ(given.outlier_ratio, 7.5);
}

TEST(CloudFilter, TellsOnlyWhatThereIs) {
  StraySamples strays;
  EXPECT_EQ(told_strays(strays), "nothing");
  strays.outliers = 1;
  EXPECT_EQ(told_strays(strays), "1 outlier");
  strays.small_parts = 3;
  strays.in_small_parts = 14;
  EXPECT_EQ(told_strays(strays), "1 outlier, and 14 points in 3 small parts");
  strays.outliers = 0;
  EXPECT_EQ(told_strays(strays), "14 points in 3 small parts");
}

TEST(CloudFilter, StraysAreTakenOutAndTheOrderStays) {
  std::vector<Point> cloud = shapes::dome_patch(20, 0.5, 1);
  cloud.insert(cloud.begin() + 7, {0.5, 0.5, 9});
  std::vector<Point> expected;
  const StraySamples strays = stray_samples(cloud);
  for (const PointId p : strays.kept.ids()) {
    if (strays.kept[p] != 0) expected.push_back(cloud[p.index()]);
  }
  EXPECT_LT(expected.size(), cloud.size());
  const StraySamples told = leave_out_strays("cloud.xyz", cloud, {}, {});
  EXPECT_EQ(told_strays(told), told_strays(strays));
  EXPECT_TRUE(cloud == expected);
  std::vector<Point> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  try {
    leave_out_strays("line.xyz", line, {}, {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("line.xyz"), std::string::npos);
  }
}

TEST(CloudFilter, AModelIsTheCloudsThatHaveAllItsVertices) {
  TriangleMesh model;
  model.points = IdVector<VertexId, Point>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  std::vector<Point> cloud = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_FALSE(is_model_itself(cloud, model));
  cloud.push_back({0, 0, 0.5});
  EXPECT_FALSE(is_model_itself(cloud, model));
  cloud.push_back({0, 0, 0});
  EXPECT_TRUE(is_model_itself(cloud, model));
}

}  // namespace
}  // namespace cocoon::app
