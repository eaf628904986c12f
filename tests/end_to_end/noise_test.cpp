// The option --noise.
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

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
  EXPECT_EQ(report["noise"]["outliers"], 10);
  EXPECT_GT(report["noise"]["layer_samples"], 100);
  EXPECT_EQ(report["input"]["points"], 2010);
  EXPECT_EQ(report["surface"]["genus"], 0);
  EXPECT_EQ(
      report["surface"]["unused_points"].get<int>() + report["surface"]["vertices"].get<int>(),
      2010);
  const ProgramRun check = run_program({"check", mesh, "--require", "closed,manifold,connected"});
  EXPECT_EQ(check.exit_code, 0) << check.error;
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

}  // namespace
}  // namespace cocoon::test
