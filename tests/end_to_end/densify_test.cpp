// A part as CAD programs give it, with few vertices and large triangles, and a scan of its change.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geom/surface_distance.h"
#include "io/mesh_file.h"
#include "tests/end_to_end/scanned_gear.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

Json report_of(const std::vector<std::string>& arguments, std::string& error) {
  std::vector<std::string> all = arguments;
  all.insert(all.end(), {"--json", "-"});
  const ProgramRun run = run_program(all);
  EXPECT_EQ(run.exit_code, 0) << run.error;
  error = run.error;
  return Json::parse(run.out);
}

std::vector<int> new_places(const std::string& map) {
  std::ifstream file(map);
  return {std::istream_iterator<int>(file), {}};
}

// Where the vertices of one mesh are in the other; -1: nowhere.
std::vector<int> places_of_vertices(const TriangleMesh& mesh, const TriangleMesh& other) {
  std::vector<int> places;
  const std::vector<Point>& points = other.points.raw();
  for (const Point& p : mesh.points) {
    const auto found = std::find(points.begin(), points.end(), p);
    places.push_back(found == points.end() ? -1 : static_cast<int>(found - points.begin()));
  }
  return places;
}

TEST(Densify, MakesAPartFitForUpdates) {
  const ScannedGear scanned;
  const auto& [folder, part, cloud] = scanned;
  const std::string dense = folder.file("dense.ply");
  const std::string updated = folder.file("updated.ply");
  std::string error;

  Json report = report_of({"update", part, cloud, "-o", updated, "--keep-coarse"}, error);
  EXPECT_GT(report["update"]["astray_area_share"].get<double>(), 0.3);
  EXPECT_NE(report["warnings"].dump().find("--densify"), std::string::npos);

  report = report_of({"reconstruct", part, "-o", dense, "--densify", "0.12"}, error);
  EXPECT_EQ(report["input"]["vertices"], 42);
  EXPECT_GT(report["input"]["added_samples"].get<int>(), 4000);
  EXPECT_FALSE(report["input"].contains("conforming_samples"));  // these suffice
  double stages = 0;                                             // each counted once
  for (const auto& [stage, seconds] : report["timings_s"].items()) {
    if (stage != "total") stages += seconds.get<double>();
  }
  EXPECT_LE(stages, report["timings_s"]["total"].get<double>());
  EXPECT_EQ(report["surface"]["unused_points"], 0);
  EXPECT_EQ(report["surface"]["genus"], 0);
  const TriangleMesh truth = read_mesh(part);
  EXPECT_LT(surface_distance(read_mesh(dense), truth, {.samples = 20000}).rms, 0.005);

  report = report_of({"update", dense, cloud, "-o", updated}, error);
  EXPECT_LT(report["update"]["lost_triangles"].get<int>(), 20);
  EXPECT_FALSE(report["update"].contains("astray_area_share"));
  EXPECT_EQ(report["warnings"].dump().find("--densify"), std::string::npos);
  EXPECT_EQ(report["surface"]["genus"], 0);
}

// Of its 20 triangles 13 are lost: its inner corner is filled.
TEST(Densify, IsSuggestedForABracketOfFewTriangles) {
  const TemporaryFolder folder;
  std::string vertices;
  for (const char* z : {" 0\n", " 1.5\n"}) {
    for (const char* xy : {"-1.5 -1.5", "6 -1.5", "6 1.5", "1.5 1.5", "1.5 6", "-1.5 6"}) {
      vertices += std::string(xy) + z;
    }
  }
  const std::string bracket = folder.write(
      "bracket.off", "OFF\n12 8 0\n" + vertices +
                         "6 0 5 4 3 2 1\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n"
                         "4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n");
  const std::string cloud = folder.write("knob.xyz", knob());
  std::string error;
  const Json report = report_of(
      {"update", bracket, cloud, "-o", folder.file("updated.ply"), "--keep-coarse"}, error);
  EXPECT_LT(report["update"]["lost_triangles"].get<int>(), 20);
  EXPECT_GT(report["update"].value("astray_area_share", 0.0), 0.05);
  EXPECT_NE(report["warnings"].dump().find("--densify"), std::string::npos) << report["warnings"];
}

// The same result as with the option that the warning names.
TEST(Densify, IsDoneWithoutBeingAskedWhereSurfaceWouldBeLost) {
  const ScannedGear scanned;
  const auto& [folder, part, cloud] = scanned;
  const std::string unasked = folder.file("unasked.ply");
  const std::string asked = folder.file("asked.ply");
  const std::string map = folder.file("map.txt");
  std::string error;
  Json report = report_of({"update", part, cloud, "-o", unasked, "--map", map}, error);
  const Json coarse = report["update"]["coarse_model"];
  EXPECT_EQ(coarse["status"], "ok");
  EXPECT_EQ(coarse["made_dense"], true);
  EXPECT_GT(coarse["lost_area_share"].get<double>(), 0.3);
  EXPECT_EQ(coarse["spacing"], report["parameters"]["densify"]);
  EXPECT_NEAR(coarse["spacing"].get<double>(), 0.09, 0.02);  // of the knob's samples
  EXPECT_FALSE(report["update"].contains("astray_area_share"));
  const std::string option = coarse["spacing"].dump();
  ASSERT_EQ(report["warnings"].size(), 1U) << report["warnings"];
  EXPECT_NE(report["warnings"][0].get<std::string>().find("--densify " + option),
            std::string::npos);
  EXPECT_EQ(report["surface"]["genus"], 0);
  EXPECT_EQ(new_places(map), places_of_vertices(read_mesh(part), read_mesh(unasked)));

  report = report_of({"update", part, cloud, "-o", asked, "--densify", option}, error);
  EXPECT_FALSE(report["update"].contains("coarse_model"));
  EXPECT_EQ(report["warnings"].size(), 0U) << report["warnings"];
  EXPECT_EQ(content_of(unasked), content_of(asked));
}

TEST(Densify, IsNotDoneWithoutBeingAskedOfDenseModels) {
  const ScannedGear scanned;
  const auto& [folder, part, cloud] = scanned;
  const std::string updated = folder.file("updated.ply");
  const std::string dense = folder.file("dense.ply");
  std::string error;
  report_of({"reconstruct", part, "-o", dense, "--densify", "0.12"}, error);
  const Json report = report_of({"update", dense, cloud, "-o", updated}, error);
  EXPECT_FALSE(report["update"].contains("coarse_model"));
  EXPECT_FALSE(report["parameters"].contains("densify"));
  EXPECT_EQ(report["parameters"]["keep_coarse"], false);
}

// All triangles of such a model are large for the scan, and of few points some for the change, too.
TEST(Densify, IsNotTriedOfModelsThatWereScannedMoreCoarsely) {
  for (const char* points : {"600", "1500"}) {
    const TemporaryFolder folder;
    const ProgramRun sampled = run_program(
        {"sample", "block", "-o", folder.file(""), "--points", points, "--cloud-points", "3000"});
    ASSERT_EQ(sampled.exit_code, 0) << sampled.error;
    const std::string model = folder.file("model.ply");
    std::string error;
    report_of({"reconstruct", folder.file("initial.xyz"), "-o", model}, error);
    const std::string cloud = folder.file("cloud-1.xyz");
    const Json report = report_of({"update", model, cloud, "-o", folder.file("new.ply")}, error);
    EXPECT_FALSE(report["update"].contains("coarse_model"));
    EXPECT_FALSE(report["timings_s"].contains("dense_samples"));
  }
}

// Samples have the color of the nearest vertex.
TEST(Densify, KeepsColorsOfModels) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write("plain.off", gear()));
  std::string colored =
      "ply\nformat ascii 1.0\nelement vertex 42\nproperty double x\nproperty double y\n"
      "property double z\nproperty uchar red\nelement face 80\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (const Point& p : mesh.points) {
    const std::string line = point_line(p.x, p.y, p.z);
    colored += line.substr(0, line.size() - 1) + (p.x < 0 ? " 200\n" : " 100\n");
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    colored += "3 " + std::to_string(a.value) + " " + std::to_string(b.value) + " " +
               std::to_string(c.value) + "\n";
  }
  const std::string part = folder.write("colored.ply", colored);
  const std::string cloud = folder.write("knob.xyz", knob());
  const std::string updated = folder.file("updated.ply");
  std::string error;
  for (const std::vector<std::string>& inputs : {std::vector<std::string>{"update", part, cloud},
                                                 {"update", part, cloud, "--densify", "0.12"},
                                                 {"reconstruct", part, "--densify", "0.12"}}) {
    std::vector<std::string> arguments = inputs;
    arguments.insert(arguments.end(), {"-o", updated, "--ascii"});
    const Json report = report_of(arguments, error);
    const bool is_asked = inputs.size() > 3;
    EXPECT_EQ(report.contains("update") && report["update"].contains("coarse_model"), !is_asked);
    std::ifstream file(updated);
    std::string line;
    while (std::getline(file, line) && line != "end_header") {
    }
    std::size_t wrong = 0;
    const auto count = report["surface"]["vertices"].get<std::size_t>();
    EXPECT_GT(count, 3000U);
    for (std::size_t v = 0; v < count; ++v) {
      double x = 0;
      double y = 0;
      double z = 0;
      int red = 0;
      file >> x >> y >> z >> red;
      const bool is_scanned = std::hypot(x, y) < 1.3;  // of the cloud, which has no colors
      const bool is_clear = std::abs(x) > 0.8;         // which vertex is near
      if (is_clear && !is_scanned) wrong += red != (x < 0 ? 200 : 100) ? 1U : 0U;
    }
    EXPECT_EQ(wrong, 0U);
  }
}

// Numbers of groups are those of the model that the same update without them takes.
TEST(Densify, WithoutBeingAskedIsTheSameWhenGroupsAreNamed) {
  const ScannedGear scanned;
  const auto& [folder, part, cloud] = scanned;
  const std::string free = folder.file("free.ply");
  const std::string named = folder.file("named.ply");
  std::string error;
  Json report = report_of({"update", part, cloud, "-o", free}, error);
  const Json replaced = report["update"]["clouds"][0]["replaced_groups"];
  ASSERT_EQ(replaced.size(), 1U);
  report = report_of({"update", part, cloud, "-o", named, "--replace-groups", replaced[0].dump()},
                     error);
  EXPECT_EQ(report["update"]["coarse_model"]["made_dense"], true);
  EXPECT_EQ(content_of(named), content_of(free));
}

// In one go, as a session and by watching a folder: the same mesh.
TEST(Densify, OfAModelIsPartOfItsUpdate) {
  const ScannedGear scanned;
  const auto& [folder, part, cloud] = scanned;
  const std::string dense = folder.file("dense.ply");
  const std::string in_two = folder.file("in_two.ply");
  const std::string in_one = folder.file("in_one.ply");
  const std::string session = folder.file("dense.session");
  const std::string of_session = folder.file("of_session.ply");
  const std::vector<std::string> option = {"--densify", "0.12"};
  const auto run = [&](std::vector<std::string> arguments, bool densify) {
    if (densify) arguments.insert(arguments.end(), option.begin(), option.end());
    const ProgramRun done = run_program(arguments);
    EXPECT_EQ(done.exit_code, 0) << done.error;
    return done;
  };
  run({"reconstruct", part, "-o", dense, "--session", session}, true);
  run({"update", dense, cloud, "-o", in_two}, false);
  const std::string map = folder.file("map.txt");
  run({"update", part, cloud, "-o", in_one, "--map", map}, true);
  EXPECT_EQ(new_places(map), places_of_vertices(read_mesh(part), read_mesh(in_one)));
  run({"update", "--session", session, cloud, "-o", of_session}, false);
  EXPECT_EQ(content_of(in_one), content_of(in_two));
  EXPECT_EQ(content_of(of_session), content_of(in_two));

  const TemporaryFolder drop;
  drop.write("knob.xyz", knob());
  const std::string watched = folder.file("watched.ply");
  std::vector<std::string> watch = {"watch",  part,       drop.file(""), "-o",     watched,
                                    "--once", "--settle", "0",           "--poll", "0.01"};
  run(watch, true);
  EXPECT_EQ(content_of(watched), content_of(in_two));
  // Taken up again it must be the same model.
  EXPECT_NE(run(watch, true).out.find("resumed"), std::string::npos);
  const ProgramRun other = run_program(watch);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.error.find("another model"), std::string::npos) << other.error;
}

// They would be spikes.
TEST(Densify, VerticesInNoTriangleAreNoSamples) {
  const TemporaryFolder folder;
  std::string with_two = gear();
  with_two.replace(with_two.find("42 80"), 5, "44 80");
  const std::size_t facets = with_two.find("3 40 1 0");
  ASSERT_NE(facets, std::string::npos);
  with_two.insert(facets, point_line(0, 0, height + 1) + point_line(2.5, 0, -1));
  std::string error;
  const auto dense = [&](const std::string& model, std::size_t warnings) {
    const std::string mesh = (folder / "dense.ply").string();
    const Json report = report_of(
        {"reconstruct", folder.write("gear.off", model), "-o", mesh, "--densify", "0.2"}, error);
    EXPECT_EQ(report["warnings"].size(), warnings);
    return read_mesh(mesh);
  };
  EXPECT_EQ(dense(with_two, 1), dense(gear(), 0));
  const std::string map = (folder / "map.txt").string();
  const Json report =
      report_of({"update", folder.write("gear.off", with_two), folder.write("knob.xyz", knob()),
                 "-o", (folder / "new.ply").string(), "--densify", "0.2", "--map", map},
                error);
  EXPECT_EQ(report["input"]["unused_vertices"], 2);
  std::ifstream lines(map);
  std::vector<std::string> places{std::istream_iterator<std::string>(lines), {}};
  ASSERT_EQ(places.size(), 44U);
  EXPECT_NE(places[0], "-1");  // on the rim, which stays
  EXPECT_EQ(places[42], "-1");
  EXPECT_EQ(places[43], "-1");
}

TEST(Densify, NeedsNoNoiseFilterAndNoSessionThatHasAModel) {
  ProgramRun run = run_program(
      {"reconstruct", "part.off", "-o", "m.ply", "--densify", "1", "--noise", "robust"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.error.find("--noise robust, or --densify"), std::string::npos) << run.error;
  run = run_program({"update", "--session", "x.session", "c.xyz", "-o", "m.ply", "--densify", "1"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.error.find("--densify"), std::string::npos) << run.error;
  run = run_program({"update", "m.off", "c.xyz", "-o", "m.ply", "--densify", "1", "--keep-coarse"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.error.find("--keep-coarse"), std::string::npos) << run.error;
  run = run_program({"watch", "m.off", "d", "-o", "m.ply", "--densify", "1", "--keep-coarse"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.error.find("--keep-coarse"), std::string::npos) << run.error;
  run = run_program({"update", "--session", "x.session", "c.xyz", "-o", "m.ply", "--keep-coarse"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.error.find("--keep-coarse"), std::string::npos) << run.error;
}

// A gear of a third of the spacing.
TEST(Densify, KeepsThinWallsOfAClosedMesh) {
  const TemporaryFolder folder;
  const std::string thin = gear(0.04);
  const std::string part = folder.write("thin.off", thin);
  const std::string dense = folder.file("dense.ply");
  std::string error;
  const Json report = report_of({"reconstruct", part, "-o", dense, "--densify", "0.12"}, error);
  EXPECT_EQ(report["surface"]["genus"], 0) << report["surface"].dump();
  EXPECT_EQ(report["parameters"]["densify"], 0.12);
  const std::string warnings = report["warnings"].dump();
  EXPECT_NE(warnings.find("too sharp"), std::string::npos);
  EXPECT_EQ(warnings.find("not closed"), std::string::npos);
  EXPECT_EQ(warnings.find("--noise"), std::string::npos) << warnings;  // there is none
  EXPECT_LT(surface_distance(read_mesh(dense), read_mesh(part), {.samples = 20000}).rms, 0.002);

  std::string open = thin;  // all but one triangle
  open.replace(open.find("42 80 0"), 7, "42 79 0");
  open.erase(open.rfind('\n', open.size() - 2) + 1);
  const std::string open_part = folder.write("open.off", open);
  const Json of_open =
      report_of({"reconstruct", open_part, "-o", dense, "--densify", "0.12"}, error);
  EXPECT_NE(of_open["warnings"].dump().find("is not closed"), std::string::npos);
}

// A block of 4 by 4 by 1 with a square hole in the middle.
std::string drilled_block(double width) {
  std::string vertices;
  for (const double z : {0.0, 1.0}) {
    for (const double half : {2.0, 0.5 * width}) {
      vertices += point_line(-half, -half, z) + point_line(half, -half, z) +
                  point_line(half, half, z) + point_line(-half, half, z);
    }
  }
  std::string faces;
  const auto face = [&](int a, int b, int c, int d) {
    faces += '4';
    for (const int v : {a, b, c, d}) {
      faces += ' ';
      faces += std::to_string(v);
    }
    faces += '\n';
  };
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    face(k, 4 + k, 4 + next, next);
    face(8 + k, 8 + next, 12 + next, 12 + k);
    face(k, next, 8 + next, 8 + k);
    face(4 + k, 12 + k, 12 + next, 4 + next);
  }
  return "OFF\n16 16 0\n" + vertices + faces;
}

// A hole of a sixth of the spacing gets samples of its own; one of a hundredth is lost, and as the
// mesh has it, that is told.
TEST(Densify, ANarrowHoleIsKeptAndALostOneTold) {
  const TemporaryFolder folder;
  const std::string out = folder.file("dense.ply");
  std::string cloud;  // a scan of a bump on the side
  for (int y = -3; y <= 3; ++y) {
    for (int z = -3; z <= 3; ++z) {
      const double bump = std::max(0, 4 - y * y - z * z);
      cloud += point_line(2 + 0.02 * bump, 0.1 * y, 0.5 + 0.1 * z);
    }
  }
  const std::string scan = folder.write("scan.xyz", cloud);
  std::string error;
  for (const double width : {0.003, 0.05, 0.6}) {
    const bool is_lost = width < 0.01;
    const std::string part = folder.write("part.off", drilled_block(width));
    Json report = report_of({"reconstruct", part, "-o", out, "--densify", "0.3"}, error);
    EXPECT_EQ(report["surface"]["genus"], is_lost ? 0 : 1);
    EXPECT_EQ(report["input"].contains("conforming_samples"), width < 0.3);
    // Those that the mesh has are no news.
    EXPECT_EQ(report["findings"].dump().find("\"handles\""), std::string::npos)
        << report["findings"];
    const std::string told = "has 0 handles, the mesh 1";
    EXPECT_EQ(report["warnings"].dump().find(told) != std::string::npos, is_lost) << error;
    report = report_of({"update", part, scan, "-o", out, "--densify", "0.3"}, error);
    EXPECT_EQ(report["warnings"].dump().find(told) != std::string::npos, is_lost) << error;
  }
}

TEST(Densify, SaysWhereASpacingAddsNoSamples) {
  const ScannedGear scanned;
  std::string error;
  const Json report = report_of(
      {"reconstruct", scanned.part, "-o", scanned.folder.file("m.ply"), "--densify", "9"}, error);
  EXPECT_EQ(report["input"]["added_samples"], 0);
  EXPECT_NE(report["warnings"].dump().find("--densify 9 adds no samples"), std::string::npos);
}

TEST(Densify, NeedsAMeshAndAPossibleSpacing) {
  const ScannedGear scanned;
  const auto& [folder, part, cloud] = scanned;
  const std::string mesh = folder.file("mesh.ply");
  ProgramRun run = run_program({"reconstruct", cloud, "-o", mesh, "--densify", "1"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.error.find("knob.xyz: --densify needs a mesh"), std::string::npos) << run.error;
  run = run_program({"reconstruct", part, "-o", mesh, "--densify", "1e-8"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.error.find("choose a spacing of"), std::string::npos) << run.error;
  for (const char* spacing : {"0", "-1", "nan", "inf", "much"}) {
    EXPECT_EQ(run_program({"reconstruct", part, "-o", mesh, "--densify", spacing}).exit_code, 2);
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"knob.xyz", "part.off"}));
}

}  // namespace
}  // namespace cocoon::test
