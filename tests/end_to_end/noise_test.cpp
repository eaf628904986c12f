// The option --noise.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

// A unit sphere whose points lie up to 0.1 outside it, and a few points far away.
std::string noisy_sphere(int count) {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - 2 * (i + 0.5) / count;
    const double ring = std::sqrt(1 - z * z);
    const double radius = 1 + 0.1 * uniform();
    text += point_line(radius * ring * std::cos(2.4 * i), radius * ring * std::sin(2.4 * i),
                       radius * z);
  }
  for (int i = 0; i < 10; ++i) text += point_line(3 * uniform(), 3 + uniform(), 3 * uniform());
  return text;
}

TEST(Noise, LayersBecomeOneClosedSurface) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", noisy_sphere(2000));
  const std::string mesh = folder.file("mesh.ply");
  const ProgramRun run =
      run_program({"reconstruct", cloud, "-o", mesh, "--noise", "robust", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  const Json report = Json::parse(run.out);
  const Json& noise = report["noise"];  // that some strays are near each other saves none
  EXPECT_EQ(noise["outliers"].get<int>() + noise["clump_samples"].get<int>(), 10);
  EXPECT_GT(report["noise"]["layer_samples"], 100);
  EXPECT_EQ(report["input"]["points"], 2010);
  EXPECT_EQ(report["surface"]["genus"], 0);
  EXPECT_EQ(
      report["surface"]["unused_points"].get<int>() + report["surface"]["vertices"].get<int>(),
      2010);
  const ProgramRun check = run_program({"check", mesh, "--require", "closed,manifold,connected"});
  EXPECT_EQ(check.exit_code, 0) << check.error;
}

TEST(Noise, ClumpsAreLeftOutAndToldOf) {
  const TemporaryFolder folder;
  std::mt19937 random(5);
  std::string text = whole_sphere(2000);
  for (int i = 0; i < 25; ++i) {
    const auto uniform = [&] { return 0.3 * static_cast<double>(random()) / 4294967296.0; };
    const double x = uniform();
    const double y = uniform();
    text += point_line(2 + x, y, uniform());
  }
  const std::string cloud = folder.write("cloud.xyz", text);
  const auto reconstructed = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"reconstruct", cloud, "-o", folder.file("mesh.ply"), "--noise",
                                     "robust", "--json", "-"});
    const ProgramRun run = run_program(options);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return Json::parse(run.out);
  };
  const Json report = reconstructed({});
  EXPECT_EQ(report["surface"]["components"], 1);
  EXPECT_EQ(report["noise"]["clumps"], 1);
  EXPECT_GE(report["noise"]["clump_samples"], 20);
  EXPECT_EQ(report["noise"]["largest_clump"], report["noise"]["clump_samples"]);
  EXPECT_EQ(report["parameters"]["noise_clump_share"], 0.02);
  EXPECT_EQ(report["parameters"]["noise_clump_link"], 2);
  EXPECT_EQ(report["parameters"]["noise_clump_depth"], 1000);
  const Json& finding = report["findings"][0];
  EXPECT_EQ(finding["kind"], "clumps");
  EXPECT_NEAR(finding["spots"][0]["at"][0].get<double>(), 2.1, 0.2);
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--noise-clump-share", "0"}, {"--noise-clump-link", "0.01"}}) {
    const Json other = reconstructed(options);
    EXPECT_NE(other["noise"]["clump_samples"], report["noise"]["clump_samples"]) << options[0];
  }
}

TEST(Noise, IsForClosedSurfacesOfPlainRuns) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(200));
  const std::string mesh = folder.file("mesh.ply");
  expect_error(run_program({"reconstruct", cloud, "-o", mesh, "--noise", "some"}), 2, "--noise");
  expect_error(
      run_program({"reconstruct", cloud, "-o", mesh, "--noise", "robust", "--surface", "cocone"}),
      2, "--surface tight");
  expect_error(run_program({"reconstruct", cloud, "-o", mesh, "--noise", "robust", "--session",
                            folder.file("s.session")}),
               2, "--session");
}

// A sphere, and a scan of a bump on it with a few points and a clump far from it.
struct DirtyScan {
  TemporaryFolder folder;
  std::string clean_text = sphere_cap(2000, 0.9, 0.3);
  std::string model = folder.write("model.xyz", whole_sphere(1500));
  std::string clean = folder.write("clean.xyz", clean_text);
  std::string dirty = folder.write("dirty.xyz", clean_text + strays());
  std::string mesh = folder.file("new.ply");

  static std::string strays() {
    std::string text =
        point_line(0.1, 0.2, 2.5) + point_line(-0.4, 0.3, 2.1) + point_line(0.9, 0.8, 1.6);
    for (int i = 0; i < 7; ++i) {
      text += point_line(0.05 * std::cos(i), 2 + 0.05 * std::sin(i), 1.5 + 0.02 * (i % 3));
    }
    return text;
  }
  std::string result_of(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"-o", mesh});
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return content_of(mesh);
  }
};

TEST(Noise, CloudsOfUpdatesLoseTheirStrays) {
  const DirtyScan scan;
  const std::string expected = scan.result_of({"update", scan.model, scan.clean});
  EXPECT_NE(scan.result_of({"update", scan.model, scan.dirty}), expected);

  const ProgramRun run = run_program({"update", scan.model, scan.dirty, "-o", scan.mesh, "--noise",
                                      "robust", "--json", scan.folder.file("report.json")});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(content_of(scan.mesh), expected);
  EXPECT_NE(run.out.find("10 points in 2 small parts left out"), std::string::npos) << run.out;
  const Json report = Json::parse(content_of(scan.folder.file("report.json")));
  const auto points =
      static_cast<int>(std::count(scan.clean_text.begin(), scan.clean_text.end(), '\n'));
  EXPECT_EQ(report["input"]["clouds"], Json::array({points + 10}));
  const Json& cloud = report["noise"]["clouds"][0];
  EXPECT_EQ(cloud["outliers"], 0);
  EXPECT_EQ(cloud["small_parts"], 2);
  EXPECT_EQ(cloud["small_part_samples"], 10);
  EXPECT_EQ(cloud["kept_points"], points);
  EXPECT_EQ(report["parameters"]["noise_outlier_ratio"], 2);
  // What is clean stays as it is.
  EXPECT_EQ(scan.result_of({"update", scan.model, scan.clean, "--noise", "robust"}), expected);
}

TEST(Noise, SessionsAndWatchedFoldersHaveTheFilter) {
  const DirtyScan scan;
  const std::string session = scan.folder.file("s.session");
  const std::vector<std::string> begin = {"reconstruct", scan.model, "--session", session};
  scan.result_of(begin);
  const std::string expected = scan.result_of({"update", "--session", session, scan.clean});
  scan.result_of(begin);
  EXPECT_EQ(scan.result_of({"update", "--session", session, scan.dirty, "--noise", "robust"}),
            expected);

  std::filesystem::create_directory(scan.folder.file("drop"));
  std::filesystem::copy(scan.dirty, scan.folder.file("drop/1.xyz"));
  std::vector<std::string> watch = {"watch",    scan.model, scan.folder.file("drop"),
                                    "--settle", "0.1",      "--poll",
                                    "0.02",     "--once",   "--noise",
                                    "robust"};
  EXPECT_EQ(scan.result_of(watch), expected);
  std::filesystem::remove(scan.mesh);  // the cloud was kept as it was applied
  EXPECT_EQ(scan.result_of(watch), expected);
}

TEST(Noise, ThresholdsOfUpdatesNeedTheFilter) {
  const DirtyScan scan;
  expect_error(run_program({"update", scan.model, scan.clean, "-o", scan.mesh,
                            "--noise-outlier-ratio", "3"}),
               2, "--noise robust");
  expect_error(run_program({"update", scan.model, scan.clean, "-o", scan.mesh, "--noise", "robust",
                            "--noise-large-ratio", "3"}),
               2, "--noise-large-ratio");
}

}  // namespace
}  // namespace cocoon::test
