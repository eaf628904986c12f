#include "app/files/model_file.h"

#include <array>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

ModelFile triangle_among(const std::vector<Point>& points, std::uint32_t a, std::uint32_t b,
                         std::uint32_t c) {
  ModelFile model;
  for (const Point& p : points) model.mesh.points.push_back(p);
  model.mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return model;
}

// Returns how many warnings there are.
std::size_t leave_out(ModelFile& model) {
  SharedArguments shared;
  shared.quiet = true;
  Job job("update", shared);
  leave_out_unused_vertices(job, "model.off", "input", model);
  return job.warnings().size();
}

TEST(ModelFile, UnusedVerticesAreLeftOut) {
  ModelFile model = triangle_among(
      {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {5, 5, 5}, {0, 1, 0}, {0, 0, 0}}, 6, 2, 5);
  const ModelFile before = model;
  leave_out(model);
  EXPECT_EQ(model.mesh.points, (IdVector<VertexId, Point>({{1, 0, 0}, {0, 1, 0}, {0, 0, 0}})));
  EXPECT_EQ(model.mesh.triangles[TriangleId(0U)],
            (Triangle{VertexId(2U), VertexId(0U), VertexId(1U)}));
  const VertexId none;
  const std::vector<VertexId> expected = {none, VertexId(2U), VertexId(0U), VertexId(0U),
                                          none, VertexId(1U), VertexId(2U)};
  EXPECT_EQ(model.vertex_of.raw(), expected);
  // Where vertices of the file have gone before.
  ModelFile again = before;
  again.vertex_of.push_back(none);
  again.vertex_of.push_back(VertexId(3U));
  again.vertex_of.push_back(VertexId(4U));
  leave_out(again);
  EXPECT_EQ(again.vertex_of.raw(), (std::vector<VertexId>{none, VertexId(0U), none}));
}

TEST(ModelFile, WithoutUnusedVerticesItStaysAsItIs) {
  ModelFile model = triangle_among({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2, 0, 1);
  leave_out(model);
  EXPECT_EQ(model.mesh.points.size(), 3U);
  EXPECT_EQ(model.mesh.triangles[TriangleId(0U)][0], VertexId(2U));
  EXPECT_TRUE(model.vertex_of.empty());
}

// A tetrahedron whose triangles share no vertices, and a triangle that has two corners at one
// place.
TEST(ModelFile, TrianglesThatVanishByWeldingAreTold) {
  const std::array<Point, 4> corners = {Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::string points;
  std::string faces;
  int vertices = 0;
  const auto add = [&](const std::array<std::size_t, 3>& triangle) {
    faces += "3";
    for (const std::size_t corner : triangle) {
      const Point& p = corners.at(corner);
      points += fmt::format("{} {} {}\n", p.x, p.y, p.z);
      faces += fmt::format(" {}", vertices++);
    }
    faces += "\n";
  };
  for (const auto& triangle :
       {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 1, 2}}) {
    add(triangle);
  }
  const TemporaryFolder folder;
  const std::string path =
      folder.write("loose.off", fmt::format("OFF\n{} 5 0\n", vertices) + points + faces);
  SharedArguments shared;
  shared.quiet = true;
  Job job("update", shared);
  const ModelFile model = read_model(job, path, "input");
  EXPECT_EQ(model.mesh.points.size(), 4U);
  EXPECT_EQ(model.mesh.triangles.size(), 4U);
  ASSERT_EQ(job.warnings().size(), 1U);
  EXPECT_EQ(job.warnings()[0], path + ": 1 face without area was left out");
  EXPECT_NE(job.report().text().find("\"faces_left_out\": 1"), std::string::npos);
}

}  // namespace
}  // namespace cocoon::app
