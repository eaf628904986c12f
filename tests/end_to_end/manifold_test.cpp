// The option --manifold, proved by the program's own certificate.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

// Spread over a shell: samples of no surface, though something is found.
std::string random_shell(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::string text;
  const auto coordinate = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  for (int i = 0; i < count;) {
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    const double square = x * x + y * y + z * z;
    if (square < 0.94 || square > 1) continue;
    text += point_line(x, y, z);
    ++i;
  }
  return text;
}

TEST(Manifold, RubbishBecomesAClosedManifold) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", random_shell(5, 2000));
  const std::string mesh = folder.file("mesh.ply");
  const std::vector<std::string> reconstruct{"reconstruct", cloud,   "-o",     mesh,
                                             "--mode",      "paper", "--json", "-"};
  const ProgramRun plain = run_program(reconstruct);
  ASSERT_EQ(plain.exit_code, 0) << plain.error;
  EXPECT_FALSE(Json::parse(plain.out).contains("manifold"));
  ASSERT_EQ(run_program({"check", mesh, "--require", "manifold"}).exit_code, 1);

  std::vector<std::string> with_option = reconstruct;
  with_option.push_back("--manifold");
  const Json report = Json::parse(run_program(with_option).out);
  EXPECT_GT(report["manifold"]["split_edges"], 0);
  EXPECT_GT(report["manifold"]["copied_vertices"], 0);
  EXPECT_EQ(report["manifold"]["unpaired_sides"], 0);
  EXPECT_EQ(report["surface"]["edge_manifold"], true);
  EXPECT_EQ(report["surface"]["vertex_manifold"], true);
  const ProgramRun check = run_program({"check", mesh, "--require", "closed,manifold,oriented"});
  EXPECT_EQ(check.exit_code, 0) << check.error;
}

TEST(Manifold, StlCannotTellCopiesApart) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", random_shell(5, 2000));
  const ProgramRun run = run_program(
      {"reconstruct", cloud, "-o", folder.file("mesh.stl"), "--mode", "paper", "--manifold"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("STL has no vertex ids"), std::string::npos) << run.out;
}

TEST(Manifold, ASessionKeepsTheSurfaceBefore) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", random_shell(5, 2000));
  std::vector<std::string> reconstruct{"reconstruct", cloud,   "-o",        folder.file("mesh.ply"),
                                       "--mode",      "paper", "--manifold"};
  const std::string words = "the session has the surface as it was before";
  EXPECT_EQ(run_program(reconstruct).out.find(words), std::string::npos);
  reconstruct.insert(reconstruct.end(), {"--session", folder.file("session")});
  const ProgramRun run = run_program(reconstruct);
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find(words), std::string::npos) << run.out;
}

TEST(Manifold, UpdateHasItToo) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(1500));
  const std::string cloud = folder.write("cloud.xyz", sphere_cap(1500, 0.6, 0.1));
  const std::string mesh = folder.file("mesh.ply");
  const ProgramRun run =
      run_program({"update", model, cloud, "-o", mesh, "--manifold", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_TRUE(Json::parse(run.out)["manifold"].contains("split_edges"));
  EXPECT_EQ(run_program({"check", mesh, "--require", "closed,manifold"}).exit_code, 0);
}

}  // namespace
}  // namespace cocoon::test
