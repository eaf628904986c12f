// Models whose triangles share no vertices, as many programs write them: equal points are one
// vertex then, and what is said of the vertices of the file stays right.
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/encoding/byte_order.h"
#include "io/mesh_file.h"
#include "tests/mesh_gallery.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

Json report_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--json", "-"});
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.error;
  return Json::accept(run.out) ? Json::parse(run.out) : Json();
}

// A bumpy cloud for a sphere, and the sphere as a mesh and as loose triangles, numbered if the
// format can.
struct Files {
  explicit Files(const std::string& soup_name)
      : model(folder.file("model.ply")),
        cloud(folder.write("cloud.xyz", sphere_cap(6000, 0.8, 0.3))),
        soup_file(folder.file(soup_name)) {
    report_of({"reconstruct", folder.write("points.xyz", whole_sphere(2000)), "-o", model});
    soup = gallery::unshared(read_mesh(model));
    VertexProperties numbers;
    numbers.rows = soup.points.size();
    numbers.columns.resize(1);
    numbers.columns[0].declaration.name = "number";
    numbers.columns[0].declaration.type = PlyType::int32;
    for (const VertexId v : soup.points.ids())
      append_little_endian(numbers.columns[0].values, v.value);
    write_mesh(soup_file, soup, numbers);
  }

  TemporaryFolder folder;
  std::string model;
  std::string cloud;
  std::string soup_file;
  TriangleMesh soup;
};

std::vector<int> places_in(const std::string& map) {
  std::istringstream lines(content_of(map));
  return {std::istream_iterator<int>(lines), {}};
}

TEST(UnsharedVertices, UpdateTakesEqualPointsAsOneVertex) {
  for (const char* name : {"soup.off", "soup.obj", "soup.ply"}) {
    SCOPED_TRACE(name);
    const Files files(name);
    const std::string out = files.folder.file("out.ply");
    const std::string map = files.folder.file("map.txt");
    const Json shared = report_of({"update", files.model, files.cloud, "-o", out});
    const Json report =
        report_of({"update", files.soup_file, files.cloud, "-o", out, "--map", map});
    EXPECT_EQ(report["input"]["welded_vertices"], files.soup.points.size() - 2000);
    EXPECT_EQ(report["input"]["points"], 2000);
    for (const char* count : {"vertices", "triangles", "watertight", "euler"}) {
      EXPECT_EQ(report["surface"][count], shared["surface"][count]) << count;
    }

    // Each vertex of the file is where the map says, or none of its place is left.
    const TriangleMesh updated = read_mesh(out);
    const std::vector<int> places = places_in(map);
    ASSERT_EQ(places.size(), files.soup.points.size());
    std::map<std::vector<double>, int> place_of;
    std::size_t kept = 0;
    for (const VertexId v : files.soup.points.ids()) {
      const Point& p = files.soup.points[v];
      const int place = places[v.index()];
      kept += place >= 0 ? 1U : 0U;
      if (place >= 0) {
        EXPECT_EQ(updated.points[VertexId(place)], p);
      }
      EXPECT_EQ(place_of.try_emplace({p.x, p.y, p.z}, place).first->second, place);
    }
    EXPECT_GT(kept, places.size() / 2);
  }
}

TEST(UnsharedVertices, TheFirstOfEqualPointsGivesTheProperties) {
  const Files files("soup.ply");
  const std::string out = files.folder.file("out.ply");
  const std::string map = files.folder.file("map.txt");
  report_of({"update", files.soup_file, files.cloud, "-o", out, "--map", map});
  MeshReadReport read;
  VertexProperties properties;
  read_mesh(out, read, properties);
  ASSERT_EQ(properties.columns.size(), 1U);
  const std::vector<int> places = places_in(map);
  std::map<int, int> first_at;
  for (std::size_t i = 0; i < places.size(); ++i) first_at.try_emplace(places[i], i);
  first_at.erase(-1);
  for (const auto& [place, first] : first_at) {
    EXPECT_EQ(load_number<std::int32_t>(properties.columns[0].values.data() + 4 * place,
                                        std::endian::little),
              first);
  }
}

TEST(UnsharedVertices, OneLineSaysSo) {
  const Files files("soup.off");
  const std::string out = files.folder.file("out.ply");
  const std::string said = files.soup_file + ": " +
                           std::to_string(files.soup.points.size() - 2000) +
                           " vertices at the place of another one taken as one with it";
  ProgramRun run = run_program({"update", files.soup_file, files.cloud, "-o", out});
  EXPECT_NE(run.out.find(said), std::string::npos) << run.out;
  run = run_program({"update", files.model, files.cloud, "-o", out});
  EXPECT_EQ(run.out.find("at the place of"), std::string::npos) << run.out;

  const std::string scans = files.folder.file("scans");
  std::filesystem::create_directory(scans);
  std::filesystem::rename(files.cloud, scans + "/cloud.xyz");
  run = run_program({"watch", files.soup_file, scans, "-o", out, "--once", "--settle", "0"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find(said), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("1 cloud applied"), std::string::npos) << run.out;
}

// The sides of the mesh are known, and the map has a line for each corner of the file.
TEST(UnsharedVertices, DensifyTakesEqualPointsAsOneVertex) {
  const TemporaryFolder folder;
  const std::string soup = folder.file("cube.off");
  write_mesh(soup, gallery::unshared(gallery::cube()));
  std::string top;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double x = 0.2 + 0.015 * i;
      const double y = 0.2 + 0.015 * j;
      top += point_line(x, y, 1 + 8 * (x - 0.2) * (0.785 - x) * (y - 0.2) * (0.785 - y));
    }
  }
  const std::string map = folder.file("map.txt");
  const Json report = report_of({"update", soup, folder.write("top.xyz", top), "-o",
                                 folder.file("out.ply"), "--densify", "0.05", "--map", map});
  EXPECT_EQ(report["input"]["welded_vertices"], 28);
  EXPECT_EQ(report["surface"]["euler"], 2);
  EXPECT_EQ(report.value("warnings", Json::array()).dump().find("not closed"), std::string::npos);
  const std::vector<int> places = places_in(map);
  ASSERT_EQ(places.size(), 36U);
  const TriangleMesh updated = read_mesh(folder.file("out.ply"));
  const TriangleMesh cube = gallery::unshared(gallery::cube());
  for (const VertexId v : cube.points.ids()) {
    EXPECT_EQ(updated.points[VertexId(places[v.index()])], cube.points[v]);
  }
}

// Bodies that touch in a vertex or an edge of their own are closed as given: they stay apart.
TEST(UnsharedVertices, WhatIsClosedAsGivenStaysAsItIs) {
  const Files files("soup.off");
  TriangleMesh mesh = read_mesh(files.model);
  TriangleMesh knob = gallery::tetrahedron();
  for (Point& p : knob.points) p = {0.05 * p.x, 0.05 * p.y, 0.05 * p.z};
  const Point shift = mesh.points[VertexId(1999)];
  for (Point& p : knob.points) p = {p.x + shift.x, p.y + shift.y, p.z + shift.z};
  const std::string touching = files.folder.file("touching.off");
  write_mesh(touching, gallery::join(mesh, knob));
  const Json report =
      report_of({"update", touching, files.cloud, "-o", files.folder.file("out.ply")});
  EXPECT_FALSE(report["input"].contains("welded_vertices"));
  EXPECT_EQ(report["input"]["points"], 2004);
}

// A model that is there twice, with vertices of its own, facing either way: the result is that of
// the model, and both vertices of a place have the same new index.
TEST(UnsharedVertices, TrianglesAtThePlaceOfOthersAreLeftOut) {
  const Files files("soup.off");
  const TriangleMesh model = read_mesh(files.model);
  const std::string expected = files.folder.file("expected.ply");
  report_of({"update", files.model, files.cloud, "-o", expected});
  const std::string twice = files.folder.file("twice.ply");
  const std::string out = files.folder.file("out.ply");
  const std::string map = files.folder.file("map.txt");
  for (const TriangleMesh& again : {model, gallery::flipped(model)}) {
    write_mesh(twice, gallery::join(model, again));
    const Json report = report_of({"update", twice, files.cloud, "-o", out, "--map", map});
    EXPECT_EQ(report["input"]["repeated_triangles"], model.triangles.size());
    EXPECT_NE(report["warnings"].dump().find("are at the place of another one, and left out"),
              std::string::npos);
    EXPECT_EQ(content_of(out), content_of(expected));
    const std::vector<int> places = places_in(map);
    ASSERT_EQ(places.size(), 2 * model.points.size());
    for (std::size_t v = 0; v < model.points.size(); ++v) {
      EXPECT_EQ(places[v], places[v + model.points.size()]);
    }
  }
}

}  // namespace
}  // namespace cocoon::test
