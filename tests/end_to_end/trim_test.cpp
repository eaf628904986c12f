// The option --trim: surfaces of open scans that stay open.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "io/mesh_file.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

const std::string hint = "or leave open what was not scanned (--trim 8)";

double longest_edge(const TriangleMesh& mesh) {
  double longest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, norm(mesh.points[t[i]] - mesh.points[t[(i + 1) % 3]]));
    }
  }
  return longest;
}

// A cap of a sphere, 607 points: the closed surface has a lid over its rim.
struct Cap {
  TemporaryFolder folder;
  std::string cloud = folder.write("cap.xyz", sphere_cap(4000, 0.8));
  std::string mesh = folder.file("cap.ply");

  ProgramRun reconstruct(const std::string& option = {}, const std::string& value = {}) const {
    std::vector<std::string> arguments{"reconstruct", cloud,    "-o",
                                       mesh,          "--json", folder.file("report.json")};
    if (!option.empty()) arguments.push_back(option);
    if (!value.empty()) arguments.push_back(value);
    return run_program(arguments);
  }
  nlohmann::json report() const {
    return nlohmann::json::parse(content_of(folder.file("report.json")));
  }
};

TEST(Trim, ALidIsNamedAndTakenAway) {
  const Cap cap;
  const ProgramRun closed = cap.reconstruct();
  EXPECT_NE(closed.out.find(hint), std::string::npos) << closed.out;
  const TriangleMesh with_lid = read_mesh(cap.mesh);
  ASSERT_TRUE(mesh_check(with_lid).open_edges == 0);

  const ProgramRun open = cap.reconstruct("--trim", "8");
  EXPECT_EQ(open.exit_code, 0) << open.error;
  EXPECT_EQ(open.out.find(hint), std::string::npos) << open.out;
  const TriangleMesh mesh = read_mesh(cap.mesh);
  const MeshReport check = mesh_check(mesh);
  EXPECT_EQ(check.components, 1U);
  EXPECT_TRUE(check.edge_manifold && check.vertex_manifold && check.oriented);
  EXPECT_EQ(mesh.points, with_lid.points);
  EXPECT_GT(check.open_edges, 8U);
  // The rim is 1.4 across, samples are 0.06 apart.
  EXPECT_GT(longest_edge(with_lid), 1.2);
  EXPECT_LT(longest_edge(mesh), 0.6);
  const nlohmann::json report = cap.report();
  EXPECT_EQ(report["trim"]["triangles"], with_lid.triangles.size() - mesh.triangles.size());
  EXPECT_EQ(report["trim"]["vertices"], 0);
  EXPECT_EQ(report["parameters"]["trim"], 8);
  EXPECT_EQ(report["surface"]["watertight"], false);
}

TEST(Trim, PointsWithoutATriangleGo) {
  const Cap cap;
  cap.folder.write("cap.xyz", sphere_cap(4000, 0.8) + point_line(0, 0, -3));
  cap.reconstruct();
  ASSERT_EQ(read_mesh(cap.mesh).points.size(), 608U);
  const ProgramRun open = cap.reconstruct("--trim", "8");
  EXPECT_EQ(open.exit_code, 0) << open.error;
  EXPECT_EQ(read_mesh(cap.mesh).points.size(), 607U);
  EXPECT_EQ(cap.report()["trim"]["vertices"], 1);
  EXPECT_EQ(cap.report()["surface"]["unused_points"], 1);
  EXPECT_NE(open.out.find("they went with the long triangles"), std::string::npos) << open.out;
}

TEST(Trim, WhatIsScannedAllAroundStaysClosed) {
  const Cap cap;
  cap.folder.write("cap.xyz", whole_sphere(1000));
  EXPECT_EQ(cap.reconstruct("--trim", "8").exit_code, 0);
  EXPECT_TRUE(mesh_check(read_mesh(cap.mesh)).open_edges == 0);
  EXPECT_EQ(cap.report()["trim"]["triangles"], 0);
}

TEST(Trim, LeavesNothingIsAnError) {
  const Cap cap;
  cap.reconstruct();
  const std::string before = content_of(cap.mesh);
  const ProgramRun run = cap.reconstruct("--trim", "1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.error.find("--trim 1 leaves no triangle"), std::string::npos) << run.error;
  EXPECT_EQ(content_of(cap.mesh), before);
}

TEST(Trim, OpensTightSurfacesThatNobodyGoesOnWith) {
  const Cap cap;
  const auto refused = [&](const std::string& option, const std::string& value) {
    const ProgramRun run =
        run_program({"reconstruct", cap.cloud, "-o", cap.mesh, "--trim", "8", option, value});
    EXPECT_EQ(run.exit_code, 2);
    return run.error;
  };
  EXPECT_NE(refused("--surface", "cocone").find("--trim needs --surface tight"), std::string::npos);
  EXPECT_NE(refused("--session", cap.folder.file("s.cocoon")).find("leave out --trim"),
            std::string::npos);
  EXPECT_EQ(cap.reconstruct("--trim", "0.5").exit_code, 2);
}

// A sheet of 41 by 41 samples with a slot from one side to its middle, 8 wide: at any rho its
// surface bridges it.
TEST(Trim, OpensTheSlotsOfAnOpenCloud) {
  const TemporaryFolder folder;
  std::string points;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 20; ++x) {
      if (std::abs(x) < 4 && y >= 0) continue;
      points += point_line(x + 0.2 * std::sin(7.0 * x + 3 * y), y + 0.2 * std::sin(5.0 * x - 4 * y),
                           0.004 * x * x);
    }
  }
  const std::string cloud = folder.write("sheet.xyz", points);
  const auto perimeter_of = [&](const std::vector<std::string>& more, nlohmann::json& report) {
    std::vector<std::string> arguments = {"boundary", cloud, "-o", folder.file("out.ply")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun said = run_program(arguments);
    EXPECT_EQ(said.out.find("--trim 5 leaves") == std::string::npos, !more.empty()) << said.out;
    arguments.insert(arguments.end(), {"--json", "-"});
    report = nlohmann::json::parse(run_program(arguments).out);
    EXPECT_EQ(report["boundary"]["loops"].size(), 1U);
    return report["boundary"]["loops"][0]["perimeter"].get<double>();
  };
  nlohmann::json report;
  EXPECT_LT(perimeter_of({}, report), 180);
  EXPECT_GT(report["boundary"]["bridging_triangles"], 10);
  EXPECT_NEAR(perimeter_of({"--trim", "5"}, report), 200, 12);
  EXPECT_FALSE(report["boundary"].contains("bridging_triangles"));
  EXPECT_EQ(report["parameters"]["trim"], 5);
  EXPECT_GT(report["trim"]["triangles"], 10);
}

}  // namespace
}  // namespace cocoon::test
