#include "app/report/update_findings.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "update/report/update_messages.h"

namespace cocoon::app {
namespace {

TEST(UpdateFindings, MessagesNameAllCloudsByTheirFiles) {
  const std::vector<std::string> names = {"left.xyz", "top.xyz", "right.xyz"};
  const std::vector<std::size_t> joined = {0, 1, 2};
  EXPECT_EQ(with_cloud_names(name_of_clouds(joined, 3) + " does not lie on the model", names),
            "left.xyz (with top.xyz and right.xyz) does not lie on the model");
  EXPECT_EQ(with_cloud_names("cloud 2 of 3: as cloud 2 of 3", names), "top.xyz: as top.xyz");
  EXPECT_EQ(with_cloud_names("nothing is wrong", names), "nothing is wrong");
  EXPECT_EQ(with_cloud_names("cloud 1 of 2 and cloud 2 of 2", {"cloud 2 of 2.xyz", "a.xyz"}),
            "cloud 2 of 2.xyz and a.xyz");
}

}  // namespace
}  // namespace cocoon::app
