#include "cocone/facets/facet_normal.h"

#include <gtest/gtest.h>
#include <map>

#include "cocone/facets/cell_order.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

TEST(OutwardNormal, HasTheSameBitsFromBothSidesAndInEveryOrder) {
  const std::vector<Point> points = shapes::random_cube(300, 1);
  std::map<std::array<Point, 3>, std::pair<Vec3, Vec3>> first;  // of both sides
  for (const std::vector<Point>& order : {points, shapes::shuffled(points, 2)}) {
    const Triangulation t = delaunay(order).triangulation;
    for (const CellId c : t.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        const Vec3 normal = outward_normal(t, f);
        const Vec3 back = outward_normal(t, t.mirror(f));
        EXPECT_EQ(back, -normal);
        const Point& corner = t.point(t.facet_vertices(f)[0]);
        EXPECT_LT(dot(normal, t.point(t.vertex(c, i)) - corner), 0);
        const auto [known, is_new] = first.try_emplace(sorted_corners(t, f), normal, back);
        if (is_new) continue;
        EXPECT_TRUE(normal == known->second.first || normal == known->second.second);
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
