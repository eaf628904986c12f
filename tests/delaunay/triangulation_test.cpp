#include "delaunay/triangulation.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/triangulation_view.h"
#include "geom/errors.h"
#include "geom/orient3d.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

TEST(Triangulation, FacetsOfACellLookOutward) {
  const Triangulation t = delaunay(gallery::uniform_cube(50)).triangulation;
  const TriangulationView view = t;
  for (const CellId c : t.cells()) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const Triangle corners = facet_vertices(t.cell(c), i);
      EXPECT_EQ(t.facet_vertices(f), corners);
      EXPECT_EQ(view.facet_vertices(f), corners);
      EXPECT_EQ(t.mirror(t.mirror(f)), f);
      EXPECT_EQ(view.mirror(f), t.mirror(f));
      EXPECT_EQ(view.canonical(f), t.canonical(f));
      EXPECT_EQ(t.canonical(f), t.canonical(t.mirror(f)));
      EXPECT_EQ(view.vertex(c, i), t.vertex(c, i));
      EXPECT_EQ(t.opposite_vertex(f), t.vertex(c, i));
      if (t.is_infinite(c)) continue;
      EXPECT_EQ(orient3d(t.point(corners[0]), t.point(corners[1]), t.point(corners[2]),
                         t.point(t.vertex(c, i))),
                Sign::negative);
    }
  }
}

TEST(Triangulation, APointsVertexIsThere) {
  std::vector<Point> different = gallery::uniform_cube(10);
  std::vector<Point> repeated = different;
  repeated.push_back(repeated[3]);
  for (const std::vector<Point>& points : {different, repeated}) {
    Triangulation t = delaunay(points).triangulation;
    EXPECT_EQ(t.vertex_of_point()[t.point_of_vertex(VertexId(3))], VertexId(3));
    const std::size_t finite_cells = t.num_finite_cells();
    for (const VertexId missing : {VertexId(10), VertexId(4000000), VertexId()}) {
      TriangulationArrays arrays = Triangulation(t).release();
      arrays.vertex_of_point[PointId(2)] = missing;
      EXPECT_THROW(Triangulation(std::move(arrays), finite_cells), InputError);
    }
  }
}

}  // namespace
}  // namespace cocoon
