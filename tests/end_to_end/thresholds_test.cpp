// Options that set thresholds of single stages.
#include <cmath>
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

Json reconstructed(const TemporaryFolder& folder, std::vector<std::string> options,
                   const std::string& points = plate) {
  std::vector<std::string> arguments{"reconstruct",           points,   "-o",
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

// Points of the unit sphere, spread evenly, moved away from its center by one factor after the
// other.
std::string spheres(std::size_t n, const std::vector<double>& factors) {
  std::string points;
  std::istringstream lines(whole_sphere(n));
  double x = 0;
  double y = 0;
  double z = 0;
  for (std::size_t i = 0; lines >> x >> y >> z; ++i) {
    const double f = factors[i % factors.size()];
    points += point_line(f * x, f * y, f * z);
  }
  return points;
}

TEST(Thresholds, TheRadiusOfTheRatioConditionIsAnOption) {
  const TemporaryFolder folder;
  const Json by_default = reconstructed(folder, {});
  EXPECT_EQ(by_default["parameters"]["radius"], "tangent-plane");
  EXPECT_EQ(reconstructed(folder, {"--radius", "tangent-plane"})["surface"], by_default["surface"]);
  const Json cocone = reconstructed(folder, {"--radius", "cocone"});
  EXPECT_EQ(cocone["parameters"]["radius"], "cocone");
  EXPECT_GT(cocone["counters"]["ratio_failed"], by_default["counters"]["ratio_failed"]);
  const Json open =
      reconstructed(folder, {"--surface", "cocone"}, folder.write("ball.xyz", whole_sphere(800)));
  EXPECT_EQ(open["parameters"]["radius"], "cocone");
  EXPECT_FALSE(open["parameters"].contains("idle_cost"));
  EXPECT_EQ(reconstructed(folder,
                          {"--mode", "paper", "--radius", "tangent-plane"})["parameters"]["radius"],
            "cocone");
}

TEST(Thresholds, WhatDoesNothingIsSaid) {
  const TemporaryFolder folder;
  const auto warnings = [&](const std::vector<std::string>& options) {
    return reconstructed(folder, options)["warnings"];
  };
  const Json same = warnings({"--mode", "paper", "--no-clean-up", "--no-deferred-seeding"});
  EXPECT_EQ(same.dump().find(" nothing with "), std::string::npos) << same;
  const Json paper = warnings({"--mode", "paper", "--cavities", "--handle-cost", "5"});
  ASSERT_FALSE(paper.empty());
  EXPECT_EQ(paper.back(), "--cavities, --handle-cost do nothing with --mode paper");
  const Json peeled = warnings({"--no-clean-up", "--max-rise", "5"});
  ASSERT_FALSE(peeled.empty());
  EXPECT_EQ(peeled.back(), "--max-rise does nothing with --no-clean-up");
}

// Outliers on all sides keep the marks of the hull away from the ball.
TEST(Thresholds, DeferredSeedingIsAnOption) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("shielded.xyz", spheres(800, {1}) + spheres(12, {2}));
  const Json marked = reconstructed(folder, {}, cloud);
  EXPECT_EQ(marked["counters"]["deferred_seeds"], 1);
  EXPECT_EQ(marked["surface"]["unused_points"], 12);
  EXPECT_EQ(marked["counters"]["clean_up"]["undecided_cells"], 0);
  EXPECT_EQ(marked["parameters"]["deferred_seeding"], true);
  const Json peeled = reconstructed(folder, {"--no-deferred-seeding"}, cloud);
  EXPECT_EQ(peeled["counters"]["deferred_seeds"], 0);
  EXPECT_GT(peeled["counters"]["clean_up"]["undecided_cells"], 800);
  EXPECT_EQ(peeled["parameters"]["deferred_seeding"], false);
}

TEST(Thresholds, OfTheNoiseFilterReachIt) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write(
      "noisy.xyz", spheres(1200, {1, 1.03, 0.98, 1.01, 0.96, 1, 1.05}) + spheres(6, {1.6}));
  const auto noise = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"--noise", "robust"});
    return reconstructed(folder, options, cloud);
  };
  const Json usual = noise({});
  EXPECT_EQ(usual["noise"]["outliers"], 6);
  EXPECT_GT(usual["noise"]["good_samples"], 0);
  EXPECT_EQ(usual["parameters"]["noise_large_ratio"], 1.7);
  EXPECT_EQ(noise({"--noise-outlier-ratio", "1000"})["noise"]["outliers"], 0);
  EXPECT_LT(noise({"--noise-large-ratio", "3"})["noise"]["large_cells"],
            usual["noise"]["large_cells"]);
  EXPECT_NE(noise({"--noise-neighbors", "9"})["noise"]["large_cells"],
            usual["noise"]["large_cells"]);
  EXPECT_LT(noise({"--noise-deep-angle", "15"})["noise"]["outer_cells"],
            usual["noise"]["outer_cells"]);
  EXPECT_EQ(usual["noise"]["held"], false);
  EXPECT_GT(usual["noise"]["inner_cells"], 0);
  EXPECT_EQ(noise({"--noise-max-leak", "1", "--noise-skin-only"})["noise"]["inner_cells"], 0);
  const Json skin = noise({"--noise-skin-only"});
  EXPECT_EQ(skin["noise"]["good_samples"], 0);
  EXPECT_EQ(skin["parameters"]["noise_keep_good"], false);
  EXPECT_EQ(skin["parameters"]["noise_spare_good"], true);
  expect_error(
      run_program({"reconstruct", cloud, "-o", folder.file("m.ply"), "--noise-large-ratio", "3"}),
      2, "--noise-large-ratio needs --noise robust");
}

// A sphere with samples below that lie six times as far apart as those above.
TEST(Thresholds, OutliersAreToldBySpacingAlone) {
  std::string text;
  for (const int count : {300, 12000}) {
    for (int i = 0; i < count; ++i) {
      const double z = 1 - (2 * i + 1.0) / count;
      if ((z < 0) != (count == 300)) continue;
      const double ring = std::sqrt(1 - z * z);
      text += point_line(ring * std::cos(2.4 * i), ring * std::sin(2.4 * i), z);
    }
  }
  const TemporaryFolder folder;
  const std::string cloud = folder.write("half.xyz", text);
  const Json usual = reconstructed(folder, {"--noise", "robust"}, cloud);
  EXPECT_EQ(usual["noise"]["outliers"], 0);
  EXPECT_GT(usual["noise"]["spared_samples"], 0);
  const Json alone = reconstructed(folder, {"--noise", "robust", "--noise-spacing-only"}, cloud);
  EXPECT_GT(alone["noise"]["outliers"], 100);
  EXPECT_EQ(alone["noise"]["spared_samples"], 0);
  EXPECT_EQ(alone["parameters"]["noise_spare_good"], false);
}

TEST(Thresholds, OfLoopsAndFindingsReachThem) {
  const TemporaryFolder folder;
  const std::string cap = folder.write("cap.xyz", sphere_cap(2000, 1.2));
  const auto loops = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"boundary", cap, "-o", folder.file("c.ply"), "--json", "-"});
    const ProgramRun run = run_program(options);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return Json::parse(run.out);
  };
  EXPECT_EQ(loops({})["boundary"]["loops"][0]["pin_hole"], false);
  const Json all_short = loops({"--min-loop-edges", "100000"});
  EXPECT_EQ(all_short["boundary"]["loops"][0]["pin_hole"], true);
  EXPECT_EQ(all_short["parameters"]["min_loop_edges"], 100000);
  EXPECT_EQ(loops({"--radius", "tangent-plane"})["parameters"]["radius"], "tangent-plane");
  const std::string shielded = folder.write("shielded.xyz", spheres(800, {1}) + spheres(12, {2}));
  const auto unused_spots = [&](const std::vector<std::string>& options) {
    const Json report = reconstructed(folder, options, shielded);
    for (const Json& finding : report["findings"]) {
      if (finding["kind"] == "unused") return finding["spots"].size();
    }
    return std::size_t{0};
  };
  EXPECT_EQ(unused_spots({}), 3U);
  EXPECT_EQ(unused_spots({"--max-spots", "7"}), 7U);
}

// A ball within a ball: the wall of a hollow, or nothing.
TEST(Thresholds, CavitiesAreAnOption) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("hollow.xyz", spheres(2000, {1}) + spheres(600, {0.5}));
  const auto surface_with = [&](const std::vector<std::string>& options) {
    return reconstructed(folder, options, cloud);
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

TEST(Thresholds, OfClosedSurfacesAreNoneOfOpenOnes) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--cavities"},
                                                 {"--no-clean-up"},
                                                 {"--no-deferred-seeding"},
                                                 {"--idle-cost", "1"}}) {
    std::vector<std::string> arguments{"reconstruct",        plate,       "-o",
                                       folder.file("m.ply"), "--surface", "cocone"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_error(run_program(arguments), 2, option.front() + " needs --surface tight");
  }
}

TEST(Thresholds, AreNotKeptBySessions) {
  const TemporaryFolder folder;
  const std::string session = folder.file("s.session");
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--idle-cost", "1"},
                                                 {"--no-clean-up"},
                                                 {"--no-deferred-seeding"},
                                                 {"--radius", "cocone"}}) {
    std::vector<std::string> arguments{"reconstruct",        plate,       "-o",
                                       folder.file("m.ply"), "--session", session};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_error(run_program(arguments), 2, "a session does not keep " + option.front() + ":");
  }
  expect_error(
      run_program({"reconstruct", plate, "-o", folder.file("m.ply"), "--mark-weight", "-1"}), 2,
      "--mark-weight");
}

}  // namespace
}  // namespace cocoon::test
