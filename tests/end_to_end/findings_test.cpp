// What the program says about surfaces that are not to be relied on.
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "geom/random/random.h"
#include "io/mesh_file.h"
#include "tests/gallery.h"
#include "tests/mesh_gallery.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

Json findings_about(const std::string& cloud_text) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", cloud_text);
  const ProgramRun run =
      run_program({"reconstruct", cloud, "-o", folder.file("mesh.ply"), "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  return Json::parse(run.out)["findings"];
}

TEST(Findings, NoneOnACleanSphere) { EXPECT_EQ(findings_about(whole_sphere(800)), Json::array()); }

TEST(Findings, NameTheGap) {
  std::string cloud;  // no points above z = 0.7
  const int count = 3000;
  for (int i = 0; i < count; ++i) {
    const double z = 0.7 - 1.7 * (i + 0.5) / count;
    const double ring = std::sqrt(1 - z * z);
    cloud += point_line(ring * std::cos(2.4 * i), ring * std::sin(2.4 * i), z);
  }
  const Json findings = findings_about(cloud);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0]["kind"], "sparse");
  EXPECT_GE(findings[0]["count"], 3);
  EXPECT_FALSE(findings[0]["message"].get<std::string>().empty());
  ASSERT_FALSE(findings[0]["spots"].empty());
  const Json& spot = findings[0]["spots"][0];
  EXPECT_NEAR(spot["at"][2].get<double>(), 0.7, 0.05);
  EXPECT_NEAR(spot["size"].get<double>(), 1.4, 0.2);  // across the gap
}

// One point astray is no reason to worry; a surface full of noise is.
TEST(Findings, AreNotesOrWarningsInTheSummary) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(800) + point_line(0, 0, 0));
  ProgramRun run = run_program({"reconstruct", cloud, "-o", folder.file("mesh.ply")});
  EXPECT_NE(run.out.find("note: 1 of 801 points is not on the surface; it is "), std::string::npos)
      << run.out;
  EXPECT_EQ(run.out.find("warning:"), std::string::npos) << run.out;
  Random random(4);
  std::string noisy;
  for (const Point& p : gallery::even_sphere(2000)) {
    const double r = 1 + random.uniform(-0.08, 0.08);  // the spacing
    noisy += point_line(r * p.x, r * p.y, r * p.z);
  }
  run = run_program({"reconstruct", folder.write("noisy.xyz", noisy), "-o", folder.file("mesh.ply"),
                     "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  const Json report = Json::parse(run.out);
  Json warnings = Json::array();
  for (const Json& finding : report["findings"]) {
    if (finding["warning"].get<bool>()) warnings.push_back(finding["message"]);
  }
  EXPECT_EQ(report["warnings"], warnings);
  EXPECT_NE(warnings.dump().find("the surface is a guess at "), std::string::npos) << warnings;
  EXPECT_NE(warnings.dump().find("; try --noise robust"), std::string::npos) << warnings;
}

// The corners of a CAD part alone are no sampling of it, but its triangles can be sampled.
TEST(Findings, OfAMeshNameItsTriangles) {
  const TemporaryFolder folder;
  const std::string part = folder.file("part.off");
  const std::string out = folder.file("mesh.ply");
  write_mesh(part, gallery::cube());
  const std::string advice = ", or sample the triangles of this mesh (--densify SPACING)";
  ProgramRun run = run_program({"reconstruct", part, "-o", out, "--rho", "0.001"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.error.find(advice), std::string::npos) << run.error;
  const std::string plate = std::string(COCOON_TEST_DATA) + "/models/plate_holes.stl";
  run = run_program({"reconstruct", plate, "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find(advice), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("--noise robust"), std::string::npos) << run.out;
  const std::string points = folder.write("points.xyz", whole_sphere(800) + point_line(9, 0, 0));
  run = run_program({"reconstruct", points, "-o", out, "--rho", "0.001"});
  EXPECT_EQ(run.error.find("mesh ("), std::string::npos) << run.error;
}

// Where there is no surface, the error names the numbers and places that say why.
TEST(Findings, ARefusalSaysWhereAndBecauseOfWhat) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(800) + point_line(9, 0, 0));
  const auto refusal = [&](const std::string& rho) {
    const ProgramRun run =
        run_program({"boundary", cloud, "-o", folder.file("mesh.ply"), "--rho", rho});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.error.find("cloud.xyz: no surface: none of the 801 samples"), std::string::npos)
        << run.error;
    return run.error;
  };
  const std::string error = refusal("0.001");
  EXPECT_NE(error.find("and --rho is 0.001"), std::string::npos) << error;
  EXPECT_NE(error.find(", near (9, 0, 0); scan more densely there, or try a larger --rho"),
            std::string::npos)
      << error;
  // with the ratio that it names, and a little more, there is a surface
  const std::string before = "the smallest ratio of radius to height is ";
  const double least = std::stod(error.substr(error.find(before) + before.size()));
  EXPECT_EQ(run_program({"boundary", cloud, "-o", folder.file("mesh.ply"), "--rho",
                         std::to_string(1.1 * least)})
                .exit_code,
            0);
}

// Samples that fill a cube are on no surface.
TEST(Findings, BoundaryTellsOfPointsThatAreLeftOut) {
  const TemporaryFolder folder;
  std::string cloud = whole_sphere(1500);
  for (const Point& p : gallery::uniform_cube(300, 5)) cloud += point_line(p.x + 4, p.y, p.z);
  const std::string both = folder.write("cloud.xyz", cloud);
  ProgramRun run =
      run_program({"boundary", both, "-o", folder.file("mesh.ply"), "--json", folder.file("j")});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  const Json report = Json::parse(content_of(folder.file("j")));
  const int unused = report["surface"]["unused_points"];
  EXPECT_GT(unused, 250);
  ASSERT_EQ(report["findings"].size(), 1U);
  EXPECT_EQ(report["findings"][0]["kind"], "unused");
  EXPECT_EQ(report["findings"][0]["count"], unused);
  EXPECT_NE(run.out.find("warning: " + std::to_string(unused) + " of 1800 points are not"),
            std::string::npos)
      << run.out;
}

// No advice names an option that the command does not have, or that is of something else there.
TEST(Findings, ARefusalAdvisesWhatCanBeDone) {
  const TemporaryFolder folder;
  const std::string few = folder.write("few.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n3 2 1\n");
  const std::string cap = folder.write("cap.xyz", sphere_cap(2000, 0.8, 0.3));
  const std::string out = folder.file("mesh.ply");
  const auto advises_filter = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", out});
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.error.find("no surface"), std::string::npos) << run.error;
    return run.error.find("(try --noise robust)") != std::string::npos;
  };
  EXPECT_TRUE(advises_filter({"reconstruct", few}));
  EXPECT_FALSE(advises_filter({"reconstruct", few, "--noise", "robust"}));
  EXPECT_FALSE(advises_filter({"reconstruct", few, "--surface", "cocone"}));
  EXPECT_FALSE(advises_filter({"boundary", few}));
  EXPECT_FALSE(advises_filter({"update", few, cap}));
  EXPECT_FALSE(advises_filter({"watch", few, folder.file("."), "--once"}));
  const ProgramRun run = run_program({"update", few, cap, "-o", out});
  EXPECT_NE(run.error.find("make the model by cocoon reconstruct"), std::string::npos) << run.error;
  EXPECT_EQ(run.error.find("and --rho is"), std::string::npos) << run.error;
}

// An update tells what is doubtful about its result, as a reconstruction does: here a small part
// beside the model.
TEST(Findings, AreToldOfUpdatesToo) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", sphere_cap(3000, 1, 0.2));
  const auto report_of = [&](const std::string& points) {
    const ProgramRun run =
        run_program({"update", folder.write("model.xyz", points), cloud, "-o",
                     folder.file("mesh.ply"), "--json", "-", "--html", folder.file("page.html")});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return Json::parse(run.out);
  };
  const std::string sphere = whole_sphere(1500);
  const Json clean = report_of(sphere);
  EXPECT_EQ(clean["findings"], Json::array());
  EXPECT_EQ(clean["warnings"], Json::array());
  const Json report = report_of(sphere + crumb());
  ASSERT_FALSE(report["findings"].empty());
  const Json& finding = report["findings"][0];
  EXPECT_EQ(finding["kind"], "fragments");
  EXPECT_NEAR(finding["spots"][0]["at"][0].get<double>(), 4, 0.2);
  const std::string message = finding["message"];
  EXPECT_NE(report["warnings"].dump().find(message), std::string::npos);
  EXPECT_NE(content_of(folder.file("page.html")).find(message), std::string::npos);
}

// The lower part of the model is rough from the beginning: a finding of each update, but news only
// to one that scans it.
TEST(Findings, SparseSamplesOfAnUpdateAreNewsAtItsOwn) {
  const TemporaryFolder folder;
  Random random(3);
  std::string model;
  for (const Point& p : gallery::even_sphere(2000)) {
    const double rough = p.z < -0.3 ? 1 + random.uniform(-0.08, 0.08) : 1;
    model += point_line(rough * p.x, rough * p.y, rough * p.z);
  }
  const std::string model_file = folder.write("model.xyz", model);
  const auto notes = [&](double side) {
    std::string cloud;
    for (const Point& p : gallery::even_sphere(2500)) {
      if (side * p.z > 0.8) cloud += point_line(p.x, p.y, p.z);
    }
    const ProgramRun run =
        run_program({"update", model_file, folder.write("cloud.xyz", cloud), "-o",
                     folder.file("mesh.ply"), "--json", folder.file("report.json")});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    const Json report = Json::parse(content_of(folder.file("report.json")));
    EXPECT_EQ(report["findings"][0]["kind"], "sparse");
    EXPECT_EQ(report["warnings"].dump().find("too sparse"), std::string::npos);
    return run.out.find("note: samples are too sparse") != std::string::npos;
  };
  EXPECT_FALSE(notes(1));
  EXPECT_TRUE(notes(-1));
}

}  // namespace
}  // namespace cocoon::test
