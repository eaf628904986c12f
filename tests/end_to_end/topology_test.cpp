// What `update` and `watch` say where the topology of the model changes.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "tests/gallery.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"
#include "tests/update/ball_with_handle.h"

namespace cocoon {
namespace {

using test::run_program;
using test::TemporaryFolder;
using Json = nlohmann::json;

constexpr const char* unscanned = "though nothing was scanned within 3 spacings of them";

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

// The part of the text from the first of these words to the end of its line.
std::string line_from(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

struct HandleOff {
  TemporaryFolder folder;
  std::string model = folder.file("model.ply");
  std::string session = folder.file("session");
  std::string drop = folder.file("drop");
  std::string cloud = drop + "/top.xyz";
  std::string out = folder.file("out.ply");

  // `least_x`: of the cloud; below -1: both feet of the handle were scanned.
  explicit HandleOff(double least_x = -2) {
    std::filesystem::create_directory(drop);
    write_points(folder.file("points.xyz"), testing::ball_with_handle());
    std::vector<Point> top = testing::top_of_ball(7);
    std::erase_if(top, [&](const Point& p) { return p.x < least_x; });
    write_points(cloud, top);
    EXPECT_EQ(
        run_program({"reconstruct", folder.file("points.xyz"), "-o", model, "--session", session})
            .exit_code,
        0);
  }
  static Json report_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    return Json::parse(run_program(arguments).out);
  }
};

TEST(Topology, WhatAnUpdateChangesIsSaid) {
  const HandleOff scene;
  const Json report = HandleOff::report_of({"update", scene.model, scene.cloud, "-o", scene.out});
  EXPECT_EQ(report["update"]["model_euler"], 0);
  EXPECT_EQ(report["update"]["updated_euler"], 2);
  EXPECT_EQ(report["surface"]["genus"], 0);
  EXPECT_GT(report["update"]["far_losses"].get<int>(), 100);
  EXPECT_EQ(report["update"]["unscanned_losses"], 0);
  EXPECT_FALSE(says(report["warnings"].dump(), unscanned));

  const std::string said = run_program({"update", scene.model, scene.cloud, "-o", scene.out}).out;
  EXPECT_EQ(line_from(said, "topology: "), "topology: Euler characteristic 0 -> 2");
  // Once more the same place: nothing changes.
  const std::string again = run_program({"update", scene.out, scene.cloud, "-o", scene.out}).out;
  EXPECT_FALSE(says(again, "topology: ")) << again;
  EXPECT_FALSE(says(again, unscanned)) << again;
}

// From scratch, by a session and by watching: the same words.
TEST(Topology, LossesAreSaidByAllThatUpdate) {
  constexpr double of_one_foot = 0.1;
  const HandleOff scene(of_one_foot);
  const std::string words = "vertices of the model are gone";
  const std::string said =
      line_from(run_program({"update", scene.model, scene.cloud, "-o", scene.out}).out, words);
  EXPECT_TRUE(says(said, unscanned));
  const std::string by_session =
      run_program({"update", "--session", scene.session, scene.cloud, "-o", scene.out}).out;
  EXPECT_EQ(line_from(by_session, words), said);
  EXPECT_TRUE(says(by_session, "topology: Euler characteristic 0 -> 2"));
  const std::string watched =
      run_program({"watch", scene.model, scene.drop, "-o", scene.folder.file("w.ply"), "--once",
                   "--poll", "0.02", "--settle", "0.05"})
          .out;
  const std::string line = line_from(watched, "top.xyz: ");
  EXPECT_TRUE(says(line, said)) << line;
  EXPECT_TRUE(says(line, "topology: Euler characteristic 0 -> 2")) << line;
}

// A cavity cannot be scanned, and is filled unless the model has it, or the published way is asked
// for: what made it is told, of points before the update.
TEST(Topology, ACavityThatIsFilledIsSaid) {
  const TemporaryFolder folder;
  std::vector<Point> points = gallery::even_sphere(2000);
  std::vector<Point> cap;
  for (const Point& p : gallery::even_sphere(2500)) {
    if (p.z > 0.8) cap.push_back(p);
  }
  for (const Point& p : gallery::even_sphere(500)) points.push_back(0.5 * p);
  write_points(folder.file("hollow.xyz"), points);
  write_points(folder.file("cap.xyz"), cap);
  const std::string said = run_program({"update", folder.file("hollow.xyz"), folder.file("cap.xyz"),
                                        "-o", folder.file("out.ply")})
                               .out;
  EXPECT_TRUE(says(said, "hollow.xyz: 500 of 2500 points are not on the surface")) << said;
  EXPECT_TRUE(says(said, "inner surfaces")) << said;

  const std::string mesh = folder.file("hollow.ply");
  ASSERT_EQ(
      run_program({"reconstruct", folder.file("hollow.xyz"), "--cavities", "-o", mesh}).exit_code,
      0);
  const std::string kept =
      run_program({"update", mesh, folder.file("cap.xyz"), "-o", folder.file("out.ply")}).out;
  EXPECT_TRUE(says(kept, "2 components")) << kept;
  EXPECT_FALSE(says(kept, "not on the surface")) << kept;
  const std::string of_mesh = run_program({"update", mesh, folder.file("cap.xyz"), "-o",
                                           folder.file("out.ply"), "--mode", "paper"})
                                  .out;
  EXPECT_TRUE(says(of_mesh, "500 vertices of the model are gone though nothing was scanned"))
      << of_mesh;
  // Once, with a place and what may be the reason.
  const std::string unused = line_from(of_mesh, "not on the surface");
  EXPECT_TRUE(says(unused, "the farthest is ")) << of_mesh;
  EXPECT_EQ(of_mesh.find("not on the surface"), of_mesh.rfind("not on the surface")) << of_mesh;
}

// A ball beside the model, scanned with it.
TEST(Topology, APartThatFloatsIsSaid) {
  const TemporaryFolder folder;
  write_points(folder.file("points.xyz"), gallery::even_sphere(2000));
  std::vector<Point> cloud;
  for (const Point& p : gallery::even_sphere(2500)) {
    if (p.z > 0.7) cloud.push_back(p);
  }
  for (const Point& p : gallery::even_sphere(150)) cloud.push_back(0.25 * p + Vec3{0, 0, 1.6});
  write_points(folder.file("cloud.xyz"), cloud);
  const std::string model = folder.file("model.ply");
  const std::string session = folder.file("session");
  ASSERT_EQ(
      run_program({"reconstruct", folder.file("points.xyz"), "-o", model, "--session", session})
          .exit_code,
      0);
  const std::vector<std::vector<std::string>> models = {{model}, {"--session", session}};
  for (const std::vector<std::string>& of : models) {
    std::vector<std::string> arguments = {"update"};
    arguments.insert(arguments.end(), of.begin(), of.end());
    arguments.insert(arguments.end(), {folder.file("cloud.xyz"), "-o", folder.file("out.ply")});
    const Json report = HandleOff::report_of(arguments);
    EXPECT_EQ(report["surface"]["components"], 2);
    EXPECT_EQ(report["update"]["loose_parts"], 1);
    EXPECT_TRUE(says(report["warnings"].dump(),
                     "1 part of the updated surface hangs together with nothing of the model "
                     "(296 triangles"))
        << report["warnings"].dump();
  }
}

// An open model is a disk before it is closed.
TEST(Topology, OfAnOpenModelIsThatOfItsCheck) {
  const TemporaryFolder folder;
  std::string sheet = "OFF\n441 800 0\n";
  for (int y = -10; y <= 10; ++y) {
    for (int x = -10; x <= 10; ++x) sheet += test::point_line(0.1 * x, 0.1 * y, 0);
  }
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      const int at = 21 * y + x;
      sheet += "3 " + std::to_string(at) + ' ' + std::to_string(at + 1) + ' ' +
               std::to_string(at + 22) + '\n';
      sheet += "3 " + std::to_string(at) + ' ' + std::to_string(at + 22) + ' ' +
               std::to_string(at + 21) + '\n';
    }
  }
  std::string cloud;
  for (int y = -5; y <= 5; ++y) {
    for (int x = -5; x <= 5; ++x) {
      cloud +=
          test::point_line(0.1 * x + 0.03, 0.1 * y + 0.03, 0.01 * std::max(0, 9 - x * x - y * y));
    }
  }
  const Json report =
      HandleOff::report_of({"update", folder.write("sheet.off", sheet),
                            folder.write("cloud.xyz", cloud), "-o", folder.file("out.ply")});
  EXPECT_EQ(report["update"]["model_euler"], 1) << report.dump();
  EXPECT_EQ(report["update"]["closed_openings"], 4 * 20 - 2);  // one corner is left out
  EXPECT_NE(report["warnings"].dump().find("78 open edges"), std::string::npos) << report.dump();
}

}  // namespace
}  // namespace cocoon
