// Updates that end in a seldom way, in the library and as the program tells of them: nothing is
// left, the angles decide nothing or hardly anything, everything was scanned anew.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/end_to_end/local_update.h"
#include "tests/run_program.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using std::numbers::pi;
using testing::cap_with_hill;
using testing::Clouds;
using testing::sphere_points;

// A model and clouds as files; `out` is not there yet.
struct Files {
  test::TemporaryFolder folder;
  std::vector<std::string> command = {"update", folder.file("model.ply")};
  std::string out = folder.file("out.ply");

  Files(const TriangleMesh& model, const Clouds& clouds) {
    write_mesh(command.back(), model);
    for (std::size_t c = 0; c < clouds.size(); ++c) {
      command.push_back(folder.file("cloud-" + std::to_string(c + 1) + ".ply"));
      write_points(command.back(), clouds[c]);
    }
    command.insert(command.end(), {"-o", out});
  }

  test::ProgramRun run(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), options.begin(), options.end());
    return test::run_program(arguments);
  }

  // Nothing is written, not even in part.
  void expect_refused(const std::vector<std::string>& options, const std::string& words) const {
    const std::vector<std::string> before = folder.names();
    test::expect_error(run(options), 1, words);
    EXPECT_EQ(folder.names(), before);
  }
};

bool warns(const UpdateResult& result, const std::string& words) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

// A plate thinner than its samples are apart: as the paper has it none of them is well sampled, but
// each sheet alone, as that of the cloud, has a surface.
TEST(UpdateOutcomes, OfAThinPlateNothingIsLeftInPaperMode) {
  TriangleMesh model = testing::block(48, 40, 1);
  for (Point& p : model.points) p = {0.5 * p.x, 0.5 * p.y, 0.3 * p.z};
  const Clouds clouds = {cap_with_hill({12, 10, 0.3}, 0.1)};
  const UpdateResult result = update_model(model, clouds, paper_update_options());
  EXPECT_EQ(result.status, UpdateStatus::empty_surface);
  EXPECT_TRUE(result.mesh.triangles.empty());
  EXPECT_TRUE(result.vertex_map.empty());
  EXPECT_GT(result.replacement.vertices.replaced, 100U);
  const std::string count = std::to_string(result.replacement.points.size());
  EXPECT_EQ(result.message, "the " + count +
                                " updated points give no closed surface; check that model and "
                                "clouds are samples of one surface at one scale; none of them "
                                "meets rho 0.8333 and alpha 30 degrees, and larger ones may do");
  EXPECT_EQ(update_model(model, clouds).status, UpdateStatus::ok);

  const Files files(model, clouds);
  files.expect_refused({"--mode", "paper", "--json", files.folder.file("report.json")},
                       "(empty_surface): " + result.message);
}

// A thimble of radius 6 that stands on its mouth, its wall leaning inward by so many degrees.
std::vector<Point> thimble(const Point& center, double lean_deg) {
  constexpr double step = 0.5;
  constexpr int rows = 8;
  std::vector<Point> points;
  const auto add_ring = [&](int row, double radius, double z) {
    const int n = std::max(1, static_cast<int>(std::round(2 * pi * radius / step)));
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * pi * (k + 0.5 * (row % 2)) / n;
      points.push_back(center + Vec3{radius * std::cos(angle), radius * std::sin(angle), z});
    }
  };
  const double slope = std::tan(lean_deg * pi / 180);
  for (int row = 0; row < rows; ++row) add_ring(row, 6 - slope * row * step, row * step);
  const double dome = 6 - slope * rows * step;
  const int dome_rows = static_cast<int>(std::round(pi / 2 * dome / step));
  for (int row = 0; row <= dome_rows; ++row) {
    const double angle = pi / 2 * row / dome_rows;
    add_ring(row, dome * std::cos(angle), rows * step + dome * std::sin(angle));
  }
  return points;
}

// The wall stands upright on the model: inside and outside are a right angle from it. (The chords
// of the mouth lie inside its circle, so by a lean of 0.6 degrees the angles are equal.) Which
// cloud it is is told.
TEST(UpdateOutcomes, AThimbleThatStandsUprightIsAmbiguous) {
  const TriangleMesh model = testing::block(40, 20, 8);
  const Clouds clouds = {cap_with_hill({30, 10, 8}, 1), thimble({12, 10, 8}, 0.6)};
  const UpdateResult result = update_model(model, clouds);
  EXPECT_EQ(result.status, UpdateStatus::ambiguous);
  EXPECT_GT(result.clouds.at(0).margin_deg, 150);
  EXPECT_LT(result.clouds.at(1).margin_deg, 0.5);
  EXPECT_TRUE(result.mesh.triangles.empty());
  EXPECT_TRUE(result.replaced_groups.empty());
  const std::string words =
      ": the regions inside and outside a rim make angles with the cloud that differ by less than "
      "1 degree (group 0: ";
  EXPECT_TRUE(result.message.starts_with("cloud 2 of 2" + words)) << result.message;
  EXPECT_TRUE(
      result.message.ends_with("); let the cloud reach farther onto unchanged surface, or "
                               "say which group goes"))
      << result.message;

  const Files files(model, clouds);
  files.expect_refused({}, "cloud-2.ply" + words);
  files.expect_refused({}, "(ambiguous): ");
}

// The person knows which of the two groups at the rim of the thimble goes. Nothing is refused then,
// and what the other cloud says holds.
TEST(UpdateOutcomes, WhoSaysWhichGroupGoesIsNotRefused) {
  const Files files(testing::block(40, 20, 8),
                    {cap_with_hill({30, 10, 8}, 1), thimble({12, 10, 8}, 0.6)});
  files.expect_refused({}, ", or say which group goes by --replace-groups");
  files.expect_refused({"--replace-groups", "7"}, "there is no group 7; they are 0 to 2");
  files.expect_refused({"--keep-groups", "0"}, "(ambiguous): ");
  const auto usual = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const test::ProgramRun run = files.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return nlohmann::json::parse(run.out);
  };
  const auto report = usual({"--replace-groups", "1"});
  EXPECT_EQ(report["update"]["replaced_groups"].dump(), "[1,2]");
  EXPECT_EQ(report["update"]["regions"][1]["replaced"], true);
  EXPECT_EQ(report["parameters"]["replace_groups"].dump(), "[1]");
  EXPECT_EQ(report["warnings"].dump().find("differ by only"), std::string::npos);
  EXPECT_TRUE(mesh_check(read_mesh(files.out)).is_closed_manifold());
  EXPECT_EQ(usual({"--keep-groups", "0,1"})["update"]["replaced_groups"].dump(), "[2]");
  EXPECT_NE(files.run({"--replace-groups", "1"}).out.find(" degrees, replaced, as was said"),
            std::string::npos);
}

// Two halves of the thimble, which overlap each other, are ambiguous together, but not by
// themselves. What is said holds for the groups that are told, those of each by itself.
TEST(UpdateOutcomes, WhatIsSaidIsOfTheGroupsThatAreTold) {
  const TriangleMesh model = testing::block(40, 20, 8);
  Clouds clouds(2);
  for (const Point& p : thimble({20, 10, 8}, 0.6)) {
    if (p.x < 21.5) clouds[0].push_back(p);
    if (p.x > 18.5) clouds[1].push_back(p);
  }
  const UpdateResult usual = update_model(model, clouds);
  const std::string apart = "clouds overlap each other, but do not make one surface (";
  ASSERT_TRUE(warns(usual, apart)) << usual.message;
  UpdateOptions options;
  options.overrides = {.replaced = {RegionId(1)}, .kept = {RegionId(0)}};
  const UpdateResult overridden = update_model(model, clouds, options);
  EXPECT_TRUE(warns(overridden, apart));
  EXPECT_EQ(overridden.regions.regions.size(), usual.regions.regions.size());
  EXPECT_EQ(overridden.clouds[0].groups.size(), usual.clouds[0].groups.size());
}

// The hill stays away, and all of the model stays.
TEST(UpdateOutcomes, WhatIsSaidToBeKeptStays) {
  const TriangleMesh model = testing::block(24, 20, 8);
  const Files files(model, {cap_with_hill({12, 10, 8}, 1)});
  const auto replaced_by = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const test::ProgramRun run = files.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return nlohmann::json::parse(run.out)["update"]["replaced_points"].get<int>();
  };
  EXPECT_GT(replaced_by({}), 50);
  EXPECT_EQ(replaced_by({"--replace-groups", "1"}), replaced_by({}));
  EXPECT_LT(replaced_by({"--keep-groups", "1"}), replaced_by({}) / 4);
}

// Inside is 12 degrees less than a right angle, outside as much more. It is done, and told.
TEST(UpdateOutcomes, AThimbleThatLeansInwardHasANarrowMargin) {
  const TriangleMesh model = testing::block(24, 20, 8);
  const Files files(model, {thimble({12, 10, 8}, 12)});
  const test::ProgramRun run = files.run({"--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  const auto report = nlohmann::json::parse(run.out);
  const double margin = report["update"]["clouds"][0]["margin_deg"];
  EXPECT_NEAR(margin, 24, 3);
  const std::string words = report["warnings"].dump();
  EXPECT_NE(words.find("cloud-1.ply: its regions differ by only "), std::string::npos) << words;
  EXPECT_NE(words.find(" degrees; look at the result"), std::string::npos) << words;
  EXPECT_TRUE(mesh_check(read_mesh(files.out)).is_closed_manifold());

  // From 30 degrees on nothing is said.
  const Files clear(model, {thimble({12, 10, 8}, 18)});
  const auto silent = nlohmann::json::parse(clear.run({"--json", "-"}).out);
  EXPECT_GT(silent["update"]["clouds"][0]["margin_deg"], 30);
  EXPECT_EQ(silent["warnings"].dump().find("differ by only"), std::string::npos);
}

// The whole sphere in two scans, with less than a facet of the model between them.
TEST(UpdateOutcomes, NotAllOfTheModelGoes) {
  const TriangleMesh model = testing::sphere(2);
  Clouds clouds(2);
  for (const Point& p : sphere_points(6000, 7)) {
    if (std::abs(p.z) > 0.13) clouds[p.z > 0 ? 0 : 1].push_back(p);
  }
  const UpdateResult result = update_model(model, clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.regions.regions.size(), 2U);
  ASSERT_EQ(result.replaced_groups.size(), 1U);
  ASSERT_FALSE(result.choice.kept_largest.is_none());
  EXPECT_NE(result.replaced_groups[0], result.choice.kept_largest);
  // Of the one that is kept no cloud is said to replace it.
  for (const CloudReport& cloud : result.clouds) {
    for (const RegionId r : cloud.replaced_groups) EXPECT_EQ(r, result.replaced_groups[0]);
  }
  EXPECT_TRUE(
      warns(result, "all regions lie under clouds; the one with the largest angle is kept"));
  EXPECT_FALSE(warns(result, "no region of the model lies inside"));

  const Files files(model, clouds);
  const auto report = nlohmann::json::parse(files.run({"--json", "-"}).out);
  EXPECT_NE(report["warnings"].dump().find("all regions lie under clouds; "), std::string::npos);

  // Said to stay, it is the other one that goes.
  UpdateOptions other_way;
  other_way.overrides.kept = result.replaced_groups;
  const UpdateResult turned = update_model(model, clouds, other_way);
  ASSERT_EQ(turned.status, UpdateStatus::ok) << turned.message;
  EXPECT_EQ(turned.replaced_groups, std::vector<RegionId>{result.choice.kept_largest});
  EXPECT_GT(turned.replacement.vertices.removed.size(), 10U);
}

// If the two scans overlap each other they are a closed surface together, and the rim of each by
// itself lies on the other one.
TEST(UpdateOutcomes, TwoScansThatCloseEachOtherAreRefused) {
  const TriangleMesh model = testing::sphere(3);
  Clouds clouds(2);
  for (const Point& p : sphere_points(6000, 7)) {
    if (p.z > -0.3) clouds[0].push_back(p);
    if (p.z < 0.3) clouds[1].push_back(p);
  }
  const UpdateResult result = update_model(model, clouds);
  EXPECT_NE(result.status, UpdateStatus::ok);
  EXPECT_TRUE(result.mesh.triangles.empty());
  ASSERT_FALSE(result.warnings.empty());
  const std::string& first = result.warnings.front();
  EXPECT_TRUE(
      first.starts_with("clouds overlap each other, but do not make one surface (cloud 1 of 2 "
                        "(with cloud 2 of 2) has no open rim (0 pin-holes, 0 seams): "))
      << first;
  EXPECT_TRUE(first.ends_with("; each is taken by itself")) << first;
  EXPECT_TRUE(result.message.ends_with("; " + first)) << result.message;
  EXPECT_TRUE(warns(result, ": lies on other clouds and is no border"));
  const std::string words = result.message.substr(result.message.find(": "));
  Files(model, clouds).expect_refused({}, words.substr(0, words.find(" (cloud 1")));
}

}  // namespace
}  // namespace cocoon
