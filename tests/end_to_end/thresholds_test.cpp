// Options that set thresholds of single stages.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

const std::string plate = std::string(COCOON_TEST_DATA) + "/models/plate_holes.stl";

Json reconstructed(const TemporaryFolder& folder, std::vector<std::string> options) {
  std::vector<std::string> arguments{"reconstruct",           plate,    "-o",
                                     folder.file("mesh.ply"), "--json", "-"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.error;
  return Json::parse(run.out);
}

// A drilled plate of which only the rims are sampled.
TEST(Thresholds, ReachTheStages) {
  const TemporaryFolder folder;
  const Json open = reconstructed(folder, {});
  EXPECT_EQ(open["surface"]["euler"], -8);
  EXPECT_EQ(open["parameters"]["idle_cost"], 8);
  EXPECT_EQ(open["parameters"]["clean_up"], true);
  const Json filled = reconstructed(folder, {"--idle-cost", "0"});
  EXPECT_EQ(filled["surface"]["euler"], 2);
  EXPECT_EQ(filled["parameters"]["idle_cost"], 0);
  const Json peeled = reconstructed(folder, {"--no-clean-up"});
  EXPECT_EQ(peeled["counters"]["clean_up"]["undecided_cells"], 0);
  EXPECT_GT(peeled["surface"]["unused_points"], 0);
  EXPECT_EQ(peeled["parameters"]["clean_up"], false);
  EXPECT_EQ(reconstructed(folder, {"--mode", "paper"})["parameters"]["clean_up"], false);
}

// A ball within a ball: the wall of a hollow, or nothing.
TEST(Thresholds, CavitiesAreAnOption) {
  const TemporaryFolder folder;
  std::string points = whole_sphere(2000);
  std::istringstream lines(whole_sphere(600));
  double x = 0;
  double y = 0;
  double z = 0;
  while (lines >> x >> y >> z) points += point_line(0.5 * x, 0.5 * y, 0.5 * z);
  const std::string cloud = folder.write("hollow.xyz", points);
  const auto surface_with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"reconstruct", cloud, "-o", folder.file("mesh.ply"),
                                         "--json", folder.file("r.json")});
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return Json::parse(content_of(folder.file("r.json")));
  };
  const Json full = surface_with({});
  EXPECT_EQ(full["surface"]["components"], 1);
  EXPECT_EQ(full["parameters"]["cavities"], false);
  const Json hollow = surface_with({"--cavities"});
  EXPECT_EQ(hollow["surface"]["components"], 2);
  EXPECT_EQ(hollow["surface"]["unused_points"], 0);
  EXPECT_EQ(hollow["surface"]["watertight"], true);
  EXPECT_EQ(hollow["counters"]["cavities"], 1);
  EXPECT_EQ(surface_with({"--cavities", "--mode", "paper"})["parameters"]["cavities"], false);
}

TEST(Thresholds, AreNotKeptBySessions) {
  const TemporaryFolder folder;
  const std::string session = folder.file("s.session");
  for (const std::vector<std::string>& option :
       {std::vector<std::string>{"--idle-cost", "1"}, {"--no-clean-up"}, {"--cavities"}}) {
    std::vector<std::string> arguments{"reconstruct",        plate,       "-o",
                                       folder.file("m.ply"), "--session", session};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_error(run_program(arguments), 2, "--session");
  }
  expect_error(
      run_program({"reconstruct", plate, "-o", folder.file("m.ply"), "--mark-weight", "-1"}), 2,
      "--mark-weight");
}

}  // namespace
}  // namespace cocoon::test
