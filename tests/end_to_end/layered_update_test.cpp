// Six views of one cap of a ball, each out of register by a third of the spacing: the surface of
// all samples has handles between the layers. Without those that crowd it has none.
#include <cstddef>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geom/point.h"
#include "geom/random/random.h"
#include "tests/layered_views.h"
#include "tests/run_program.h"
#include "tests/temporary_folder.h"
#include "tests/test_clouds.h"
#include "update/checks/crowded_samples.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

std::string text_of(const std::vector<Point>& points) {
  std::string text;
  for (const Point& p : points) text += point_line(p.x, p.y, p.z);
  return text;
}

// The number that the warning of layers names, or nothing if there is no such warning.
std::string advised_distance(const std::string& out) {
  const std::string advice = "try --thin ";
  const std::size_t layers = out.find("in layers");
  const std::size_t begin = out.find(advice, layers);
  if (layers == std::string::npos || begin == std::string::npos) return "";
  const std::size_t number = begin + advice.size();
  return out.substr(number, out.find_first_not_of("0123456789.", number) - number);
}

TEST(LayeredUpdate, CrowdedSamplesAreLeftOutWhereThatMendsIt) {
  const TemporaryFolder folder;
  Random random(1);
  const std::string points = folder.write("ball.xyz", text_of(noisy_ball(0, random)));
  const std::string model = folder.file("ball.ply");
  ASSERT_EQ(run_program({"reconstruct", points, "-o", model}).exit_code, 0);
  std::size_t mended = 0;
  for (int trial = 0; trial < 4; ++trial) {
    const std::vector<Point> samples = layered_cap(0.35 * spacing_of_ball, random);
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
    const std::string out = updated({"--keep-crowded"}, report);
    EXPECT_EQ(report["parameters"]["keep_crowded"], true);
    const std::string distance = advised_distance(out);
    if (distance.empty()) continue;
    EXPECT_EQ(report["update"]["left_out_samples"], 0);
    EXPECT_GT(report["update"]["crowded_samples"], samples.size() / 4);
    EXPECT_GT(report["update"]["crowded_thickness"], CrowdedOptions().min_thickness);
    EXPECT_NE(report["surface"]["euler"], 2);
    const std::string thinned = updated({"--thin", distance}, report);
    EXPECT_EQ(report["surface"]["euler"], 2);
    EXPECT_EQ(thinned.find("in layers"), std::string::npos);
    EXPECT_FALSE(report["update"].contains("crowded_samples"));
    const std::string html = folder.file("report.html");
    updated({"--html", html}, report);
    EXPECT_EQ(report["surface"]["euler"], 2);
    EXPECT_EQ(report["surface"]["components"], 1);
    EXPECT_EQ(report["update"]["left_out_samples"], report["update"]["crowded_samples"]);
    EXPECT_NE(report["warnings"].dump().find("are left out"), std::string::npos);
    EXPECT_NE(content_of(html).find("left out, in layers"), std::string::npos);
    ++mended;
  }
  EXPECT_EQ(mended, 2U);
}

}  // namespace
}  // namespace cocoon::test
