// The option --thin.
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "io/mesh_file.h"
#include "tests/end_to_end/watched_folder.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

// Six scans of the unit sphere, one over the other, with noise: a PLY file whose points are
// numbered.
std::string noisy_layers() {
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::string lines;
  const int count = 9000;
  for (int i = 0; i < count; ++i) {
    const double z = 2 * uniform() - 1;
    const double around = 6.283185307179586 * uniform();
    const double ring = std::sqrt(1 - z * z);
    const double radius = 1 + 0.03 * (uniform() + uniform() + uniform() - 1.5);
    std::string line =
        point_line(radius * ring * std::cos(around), radius * ring * std::sin(around), radius * z);
    line.back() = ' ';
    lines += line + std::to_string(i) + "\n";
  }
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty int number\n"
         "end_header\n" +
         lines;
}

// The numbers of the points of such a file, in text, by their coordinates.
std::map<std::tuple<double, double, double>, int> numbers(const std::string& path) {
  std::ifstream file(path);
  std::map<std::tuple<double, double, double>, int> number;
  std::size_t rows = 0;
  for (std::string line; line != "end_header" && std::getline(file, line);) {
    if (line.starts_with("element vertex ")) rows = std::stoul(line.substr(15));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    double x = 0;
    double y = 0;
    double z = 0;
    file >> x >> y >> z;
    file >> number[{x, y, z}];
  }
  return number;
}

TEST(Thin, MakesAClosedSurfaceOfNoisyLayers) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.ply", noisy_layers());
  const std::string mesh = folder.file("mesh.ply");
  const auto reconstructed = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"reconstruct", cloud, "-o", mesh, "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return Json::parse(run.out);
  };
  const Json noisy = reconstructed({});
  EXPECT_NE(noisy["surface"]["euler"], 2);
  EXPECT_NE(noisy["warnings"].dump().find("--thin 0.09"), std::string::npos) << noisy["warnings"];
  const Json report = reconstructed({"--thin", "0.09"});
  EXPECT_EQ(report["surface"]["genus"], 0);
  EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
  EXPECT_EQ(report["parameters"]["thin"], 0.09);
  EXPECT_EQ(report["input"]["points"].get<int>() + report["input"]["thinned_points"].get<int>(),
            9000);
  const IdVector<VertexId, Point> vertices = read_mesh(mesh).points;
  for (const VertexId v : vertices.ids()) {
    for (const VertexId w : vertices.ids()) {
      if (v < w) {
        EXPECT_GE(squared_distance(vertices[v], vertices[w]), 0.09 * 0.09);
      }
    }
  }
}

TEST(Thin, KeepsThePropertiesOfThePointsThatStay) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.ply", noisy_layers());
  for (const std::string command : {"reconstruct", "boundary"}) {
    const std::string mesh = folder.file(command + ".ply");
    const ProgramRun run = run_program({command, cloud, "-o", mesh, "--thin", "0.09", "--ascii"});
    ASSERT_EQ(run.exit_code, 0) << run.error;
    const auto of_cloud = numbers(cloud);
    const auto of_mesh = numbers(mesh);
    EXPECT_GT(of_mesh.size(), 300U);
    for (const auto& [at, number] : of_mesh) EXPECT_EQ(of_cloud.at(at), number);
  }
}

TEST(Thin, HoldsForTheCloudsOfAnUpdate) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(1500));
  const std::string session = folder.file("model.session");
  ASSERT_EQ(
      run_program({"reconstruct", model, "-o", folder.file("model.ply"), "--session", session})
          .exit_code,
      0);
  const std::string cap = folder.write("cap.xyz", sphere_cap(16000, 0.8, 0.2));
  const std::vector<std::string> rest = {cap,      "-o", folder.file("out.ply"), "--thin", "0.05",
                                         "--json", "-"};
  std::vector<std::string> from_model = {"update", folder.file("model.ply")};
  std::vector<std::string> from_session = {"update", "--session", session};
  std::vector<int> points;
  for (std::vector<std::string> arguments : {from_model, from_session}) {
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    const ProgramRun run = run_program(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.error;
    const Json report = Json::parse(run.out);
    const int left = report["input"]["clouds"][0];
    const int gone = report["input"]["thinned_points"];
    EXPECT_GT(gone, left);
    EXPECT_EQ(report["surface"]["genus"], 0);
    points.push_back(report["surface"]["vertices"]);
  }
  EXPECT_EQ(points[0], points[1]);
}

// Three times as far apart on one half as on the other.
std::string uneven_cap() {
  std::string points;
  for (const std::size_t density : {2000U, 18000U}) {
    std::istringstream cap(sphere_cap(density, 0.8, 0.2));
    for (std::string line; std::getline(cap, line);) {
      if ((std::stod(line) < 0) == (density == 2000U)) points += line + "\n";
    }
  }
  return points;
}

TEST(Thin, IsAdvisedForCloudsOfUnevenDensity) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(1500));
  const std::string cloud = folder.write("cap.xyz", uneven_cap());
  const auto updated = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"update", model, cloud, "-o", folder.file("out.ply")});
    const ProgramRun run = run_program(options);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return run.out;
  };
  const std::string note = "samples are 0.02";
  EXPECT_NE(updated({}).find(note), std::string::npos) << updated({});
  EXPECT_NE(updated({}).find("try --thin 0.0"), std::string::npos);
  EXPECT_EQ(updated({"--thin", "0.05"}).find(note), std::string::npos);
}

TEST(Thin, HoldsForWatchedClouds) {
  const Watched watched;
  watched.put("a.xyz", sphere_cap(16000, 0.8, 0.2));
  std::vector<std::string> arguments = watched.once();
  arguments.insert(arguments.end(), {"--thin", "0.05"});
  const ProgramRun run = run_program(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("points left out by --thin"), std::string::npos) << run.out;
}

TEST(Thin, IsAdvisedForWatchedClouds) {
  const Watched watched;
  watched.put("a.xyz", uneven_cap());
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("; note: a.xyz: samples are 0.02"), std::string::npos) << run.out;
}

TEST(Thin, RefusesDistancesThatLeaveNothing) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(100));
  const std::string mesh = folder.file("mesh.ply");
  const ProgramRun far = run_program({"reconstruct", cloud, "-o", mesh, "--thin", "5"});
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_NE(far.error.find("--thin 5 leaves 1 of 100 points; the cloud is 3.4"), std::string::npos)
      << far.error;
  for (const std::string distance : {"0", "-1", "nan"}) {
    EXPECT_EQ(run_program({"reconstruct", cloud, "-o", mesh, "--thin", distance}).exit_code, 2);
  }
  EXPECT_EQ(
      run_program({"reconstruct", cloud, "-o", mesh, "--thin", "1", "--densify", "1"}).exit_code,
      2);
}

}  // namespace
}  // namespace cocoon::test
