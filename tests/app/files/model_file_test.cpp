#include "app/files/model_file.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cocoon::app
