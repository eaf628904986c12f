// Models of other programs: facing inward, with triangles at odds, with open places.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "io/mesh_file.h"
#include "tests/mesh_gallery.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

class MisorientedModels : public ::testing::Test {
 protected:
  TemporaryFolder folder;
  std::string points = folder.write("points.xyz", whole_sphere(2000));
  std::string cloud = folder.write("cloud.xyz", sphere_cap(6000, 0.8, 0.3));

  TriangleMesh ball() {
    const std::string file = folder.file("ball.ply");
    EXPECT_EQ(run_program({"reconstruct", points, "-o", file}).exit_code, 0);
    return read_mesh(file);
  }
  // The updated mesh, and the report.
  std::pair<std::string, Json> updated(const TriangleMesh& model) {
    const std::string file = folder.file("model.off");
    const std::string out = folder.file("out.ply");
    write_mesh(file, model);
    const ProgramRun run = run_program({"update", file, cloud, "-o", out, "--json", "-"});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return {content_of(out), Json::parse(run.out)};
  }
};

TEST_F(MisorientedModels, AreUpdatedLikeThoseThatFaceOutward) {
  const TriangleMesh model = ball();
  const auto [expected, plain] = updated(model);
  EXPECT_FALSE(plain["input"].contains("turned_triangles"));
  const auto [inward, report] = updated(gallery::flipped(model));
  EXPECT_EQ(inward, expected);
  EXPECT_EQ(report["input"]["turned_triangles"], model.triangles.size());

  TriangleMesh at_odds = model;
  for (const TriangleId t : at_odds.triangles.ids()) {
    if (t.index() % 3 == 0) std::swap(at_odds.triangles[t][1], at_odds.triangles[t][2]);
  }
  EXPECT_EQ(updated(at_odds).first, expected);
}

// What no triangle uses is no part of the model; the numbers of the others are those of the file.
TEST_F(MisorientedModels, VerticesWithoutATriangleAreTold) {
  const TriangleMesh model = ball();
  const auto [expected, plain] = updated(model);
  EXPECT_FALSE(plain["input"].contains("unused_vertices"));
  TriangleMesh with_others = model;
  with_others.points.push_back(model.points[VertexId(7)]);  // which says nothing new
  with_others.points.push_back({0, 0, 0});
  with_others.points.push_back({5, 0, 0});
  const auto [mesh, report] = updated(with_others);
  EXPECT_EQ(mesh, expected);
  EXPECT_EQ(report["input"]["unused_vertices"], 2);
  bool is_told = false;
  for (const Json& warning : report["warnings"]) {
    is_told |=
        warning.get<std::string>().find("2 vertices are in no triangle") != std::string::npos;
  }
  EXPECT_TRUE(is_told);
}

TEST_F(MisorientedModels, AreWatchedLikeThoseThatFaceOutward) {
  const TriangleMesh model = ball();
  const std::string scans = folder.file("scans");
  std::filesystem::create_directory(scans);
  std::filesystem::copy(cloud, scans + "/cloud.xyz");
  const std::string file = folder.file("inward.off");
  write_mesh(file, gallery::flipped(model));
  const std::string out = folder.file("live.ply");
  const ProgramRun run = run_program({"watch", file, scans, "-o", out, "--once", "--settle", "0"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("turned around"), std::string::npos) << run.out;
  EXPECT_EQ(content_of(out), updated(model).first);
}

// The holes are closed by the update, which changes the Euler number without a handle.
TEST_F(MisorientedModels, ClosedHolesAreNoHandles) {
  TriangleMesh open = ball();
  TriangleMesh model{open.points, {}};
  for (const TriangleId t : open.triangles.ids()) {
    if (t.index() % 97 != 0) model.triangles.push_back(open.triangles[t]);
  }
  const auto [mesh, report] = updated(model);
  EXPECT_EQ(report["surface"]["euler"], 2);
  EXPECT_EQ(report["update"]["unexplained_handles"], 0);
}

}  // namespace
}  // namespace cocoon::test
