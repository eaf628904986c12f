// What the program says about surfaces that are not to be relied on.
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

Json findings_about(const std::string& cloud_text) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", cloud_text);
  const ProgramRun run =
      run_program({"reconstruct", cloud, "-o", folder.file("mesh.ply"), "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  return Json::parse(run.out)["findings"];
}

TEST(Findings, NoneOnACleanSphere) { EXPECT_EQ(findings_about(whole_sphere(800)), Json::array()); }

TEST(Findings, NameTheGap) {
  std::string cloud;  // no points above z = 0.7
  const int count = 3000;
  for (int i = 0; i < count; ++i) {
    const double z = 0.7 - 1.7 * (i + 0.5) / count;
    const double ring = std::sqrt(1 - z * z);
    cloud += point_line(ring * std::cos(2.4 * i), ring * std::sin(2.4 * i), z);
  }
  const Json findings = findings_about(cloud);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0]["kind"], "sparse");
  EXPECT_GE(findings[0]["count"], 3);
  EXPECT_FALSE(findings[0]["message"].get<std::string>().empty());
  ASSERT_FALSE(findings[0]["spots"].empty());
  const Json& spot = findings[0]["spots"][0];
  EXPECT_NEAR(spot["at"][2].get<double>(), 0.7, 0.05);
  EXPECT_NEAR(spot["size"].get<double>(), 1.4, 0.2);  // across the gap
}

TEST(Findings, AreWarningsInTheSummary) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(800) + point_line(0, 0, 0));
  const ProgramRun run = run_program({"reconstruct", cloud, "-o", folder.file("mesh.ply")});
  EXPECT_NE(run.out.find("warning: 1 of 801 points is not on the surface; it is "),
            std::string::npos)
      << run.out;
}

}  // namespace
}  // namespace cocoon::test
