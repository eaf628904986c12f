// Six views of one cap of a ball, each out of register by a third of the spacing: the surface of
// all samples has handles between the layers. What the note says mends it.
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include "geom/point.h"
#include "geom/random/random.h"
#include "tests/gallery.h"
#include "tests/run_program.h"
#include "tests/temporary_folder.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

constexpr std::size_t samples_of_ball = 3000;
const double spacing = std::sqrt(4 * std::numbers::pi / samples_of_ball);

// Each sample moved by up to `noise`.
std::vector<Point> ball(double noise, Random& random) {
  std::vector<Point> points = gallery::even_sphere(samples_of_ball);
  for (Point& p : points) {
    for (double* c : {&p.x, &p.y, &p.z}) *c += random.uniform(-noise, noise);
  }
  return points;
}

std::vector<Point> layered_cap(double shift, Random& random) {
  std::vector<Point> points;
  for (int view = 0; view < 6; ++view) {
    Vec3 by{};
    for (double* c : {&by.x, &by.y, &by.z}) *c = random.uniform(-shift, shift);
    const double turn = random.uniform(0, 6);
    for (const Point& p : ball(0.05 * spacing, random)) {
      if (p.z < 0.75) continue;
      points.push_back(Point{p.x * std::cos(turn) - p.y * std::sin(turn),
                             p.x * std::sin(turn) + p.y * std::cos(turn), p.z} +
                       by);
    }
  }
  return points;
}

std::string text_of(const std::vector<Point>& points) {
  std::string text;
  for (const Point& p : points) text += point_line(p.x, p.y, p.z);
  return text;
}

TEST(LayeredUpdate, TheNoteNamesADistanceThatMendsIt) {
  const TemporaryFolder folder;
  Random random(3);
  const std::string points = folder.write("ball.xyz", text_of(ball(0, random)));
  const std::string model = folder.file("ball.ply");
  ASSERT_EQ(run_program({"reconstruct", points, "-o", model}).exit_code, 0);
  std::size_t noted = 0;
  for (int trial = 0; trial < 3; ++trial) {
    const std::vector<Point> samples = layered_cap(0.35 * spacing, random);
    const std::string cloud = folder.write("cap.xyz", text_of(samples));
    const std::string mesh = folder.file("updated.ply");
    const std::string json = folder.file("report.json");
    const auto updated = [&](const std::vector<std::string>& options, Json& report) {
      std::vector<std::string> arguments = {"update", model, cloud, "-o", mesh, "--json", json};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const ProgramRun run = run_program(arguments);
      EXPECT_EQ(run.exit_code, 0) << run.error;
      report = Json::parse(content_of(json));
      return run.out;
    };
    Json report;
    const std::string out = updated({}, report);
    std::smatch match;
    if (!std::regex_search(out, match, std::regex("in layers.*try --thin ([0-9.]+)"))) continue;
    ++noted;
    EXPECT_GT(report["update"]["crowded_samples"], samples.size() / 4);
    EXPECT_NE(report["surface"]["euler"], 2);
    const std::string thinned = updated({"--thin", match[1]}, report);
    EXPECT_EQ(report["surface"]["euler"], 2);
    EXPECT_EQ(report["surface"]["components"], 1);
    EXPECT_EQ(thinned.find("in layers"), std::string::npos);
    EXPECT_FALSE(report["update"].contains("crowded_samples"));
  }
  EXPECT_GE(noted, 2U);
}

}  // namespace
}  // namespace cocoon::test
