#include "app/updating.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "update/report/update_messages.h"

namespace cocoon::app {
namespace {

TEST(Updating, MessagesNameAllCloudsByTheirFiles) {
  const std::vector<std::string> names = {"left.xyz", "top.xyz", "right.xyz"};
  const std::vector<std::size_t> joined = {0, 1, 2};
  EXPECT_EQ(with_cloud_names(name_of_clouds(joined, 3) + " does not lie on the model", names),
            "left.xyz (with top.xyz and right.xyz) does not lie on the model");
  EXPECT_EQ(with_cloud_names("cloud 2 of 3: as cloud 2 of 3", names), "top.xyz: as top.xyz");
  EXPECT_EQ(with_cloud_names("nothing is wrong", names), "nothing is wrong");
  EXPECT_EQ(with_cloud_names("cloud 1 of 2 and cloud 2 of 2", {"cloud 2 of 2.xyz", "a.xyz"}),
            "cloud 2 of 2.xyz and a.xyz");
}

TEST(Updating, AModelIsTheCloudsThatHaveAllItsVertices) {
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
