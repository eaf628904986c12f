#include "cocone/noise/rough_surface.h"

#include <gtest/gtest.h>

#include "delaunay/delaunay.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

struct Rough {
  explicit Rough(const std::vector<Point>& points)
      : triangulation(delaunay(points).triangulation),
        dual(voronoi_dual(triangulation)),
        surface(triangulation, dual, options) {}
  ReconstructOptions options;
  Triangulation triangulation;
  Dual dual;
  RoughSurface surface;
};

// Every cell of a sphere is inside, and one disk surrounds every sample; not a point off it.
TEST(RoughSurface, TellsGoodSamplesAndTheOutside) {
  std::vector<Point> points = shapes::sphere(500, 1);
  points.push_back({5, 0, 0});
  const Rough rough(points);
  const VertexId stray = rough.triangulation.vertex_of_point()[PointId(500)];
  std::size_t good = 0;
  for (const VertexId v : rough.triangulation.vertices()) good += rough.surface.good()[v];
  EXPECT_EQ(rough.surface.good()[stray], 0);
  EXPECT_GE(good, 480U);
  const IdVector<CellId, std::uint8_t> outside = rough.surface.outside();
  ASSERT_EQ(outside.size(), rough.triangulation.num_cells());
  for (const CellId c : rough.triangulation.finite_cells()) {
    bool at_stray = false;
    for (const VertexId v : rough.triangulation.cell(c).vertices) at_stray |= v == stray;
    EXPECT_EQ(outside[c] != 0, at_stray);
  }
}

TEST(RoughSurface, WithoutASurfaceNothingIsGood) {
  const Rough rough({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(rough.surface.good(), VertexSet(4, 0));
  EXPECT_TRUE(rough.surface.outside().empty());
}

}  // namespace
}  // namespace cocoon
