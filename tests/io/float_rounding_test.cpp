#include "io/float_rounding.h"

#include <cmath>
#include <gtest/gtest.h>

#include "io/mesh_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

// Two of its corners are 1 apart.
TriangleMesh tetrahedron_at(double x) {
  const auto v = [](std::size_t i) { return VertexId(i); };
  return {IdVector<VertexId, Point>({{x, 0, 0}, {x + 1, 0, 0}, {x, 16, 0}, {x, 0, 16}}),
          IdVector<TriangleId, Triangle>(
              {{v(0), v(2), v(1)}, {v(0), v(1), v(3)}, {v(1), v(2), v(3)}, {v(0), v(3), v(2)}})};
}

// From 2^24 on floats are 2 apart, a tie goes to the even one.
TEST(FloatRounding, VerticesThatFallTogetherAreNoticed) {
  const FloatRounding far = float_rounding(tetrahedron_at(0x1p24));
  EXPECT_EQ(far.merged_vertices, 1U);
  EXPECT_EQ(far.largest_move, 1);
  EXPECT_EQ(far.median_edge, std::sqrt(257.0));
  EXPECT_TRUE(far.is_noticeable());
  EXPECT_FALSE(float_rounding(tetrahedron_at(0x1p23)).is_noticeable());
  EXPECT_EQ(float_rounding(tetrahedron_at(0x1p23)).largest_move, 0);
}

TEST(FloatRounding, VerticesAtOnePlaceBeforeAreNotNoticed) {
  TriangleMesh mesh = tetrahedron_at(0);
  for (Point& p : mesh.points) p.x += 0.1;
  mesh.points[VertexId(3)] = mesh.points[VertexId(0)];
  mesh.points.push_back({1e300, 0, 0});  // no corner of a triangle
  const FloatRounding rounding = float_rounding(mesh);
  EXPECT_EQ(rounding.merged_vertices, 0U);
  EXPECT_GT(rounding.largest_move, 0);
  EXPECT_FALSE(rounding.is_noticeable());
}

// Between 2^23 and 2^24 by up to a half.
TEST(FloatRounding, MovesAreMeasuredByTheMedianEdge) {
  TriangleMesh mesh = tetrahedron_at(0x1p23);
  mesh.points[VertexId(0)].x -= 0.75;
  mesh.points[VertexId(1)].x += 0.25;
  EXPECT_EQ(float_rounding(mesh).largest_move, 0.25);
  EXPECT_FALSE(float_rounding(mesh).is_noticeable());
  for (Point& p : mesh.points) p = {p.x, p.y / 8, p.z / 8};
  EXPECT_EQ(float_rounding(mesh).merged_vertices, 0U);
  EXPECT_TRUE(float_rounding(mesh).is_noticeable());
}

// Their squares, and those of the moves, are no doubles.
TEST(FloatRounding, TinyMeshesFallTogether) {
  for (const double size : {1e-170, 1e-300}) {
    TriangleMesh mesh = tetrahedron_at(0);
    for (Point& p : mesh.points) p = size * p;
    const FloatRounding rounding = float_rounding(mesh);
    EXPECT_EQ(rounding.merged_vertices, 3U);
    EXPECT_DOUBLE_EQ(rounding.largest_move, 16 * size);
    EXPECT_DOUBLE_EQ(rounding.median_edge, std::sqrt(257.0) * size);
    EXPECT_TRUE(rounding.is_noticeable());
  }
}

TEST(FloatRounding, WritersOfFloatsTellIt) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = tetrahedron_at(0x1p24);
  FileBatch batch;
  EXPECT_EQ(write_mesh(folder / "a.stl", mesh, {}, &batch).merged_vertices, 1U);
  EXPECT_EQ(write_mesh(folder / "a.ply", mesh, {.single_precision = true}).merged_vertices, 1U);
  EXPECT_EQ(write_mesh(folder / "b.stl", mesh, {.ascii = true}, &batch).largest_move, 0);
  EXPECT_EQ(write_mesh(folder / "b.ply", mesh, {}, &batch).largest_move, 0);
  write_mesh(folder / "c.stl", tetrahedron_at(0.1), {}, &batch);
  const std::vector<RoundedFile> rounded = batch.take_rounded();
  ASSERT_EQ(rounded.size(), 1U);
  EXPECT_EQ(rounded[0].target, folder / "a.stl");
  EXPECT_TRUE(batch.take_rounded().empty());
}

}  // namespace
}  // namespace cocoon
