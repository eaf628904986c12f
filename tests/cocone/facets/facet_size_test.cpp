#include "cocone/facets/facet_size.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// A right angle: half of the hypotenuse.
TEST(FacetSize, OfTrianglesKnownByHand) {
  const Triangulation t =
      delaunay(std::vector<Point>{{0, 0, 0}, {6, 0, 0}, {0, 8, 0}, {0, 0, 1}}).triangulation;
  ASSERT_EQ(t.num_finite_cells(), 1U);
  std::size_t checked = 0;
  for (int i = 0; i < 4; ++i) {
    const FacetSize size = size_of_facet(t, facet_id(CellId(0), i));
    if (size.corners[0].z != 0 || size.corners[1].z != 0 || size.corners[2].z != 0) continue;
    EXPECT_EQ(size.squared_circumradius, 25);
    EXPECT_EQ(size.corners, (std::array<Point, 3>{{{0, 0, 0}, {0, 8, 0}, {6, 0, 0}}}));
    ++checked;
  }
  EXPECT_EQ(checked, 1U);
}

TEST(FacetSize, IsTheSameFromBothSidesAndOrdersAllFacets) {
  for (const std::vector<Point>& points :
       {gallery::uniform_cube(300), gallery::integer_grid(5), gallery::plane_and_apex(6)}) {
    const Triangulation t = delaunay(points).triangulation;
    std::vector<FacetSize> sizes;
    for (const CellId c : t.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (t.canonical(f) != f) continue;
        sizes.push_back(size_of_facet(t, f));
        const FacetSize behind = size_of_facet(t, t.mirror(f));
        EXPECT_EQ(sizes.back().squared_circumradius, behind.squared_circumradius);
        EXPECT_EQ(sizes.back().corners, behind.corners);
        EXPECT_FALSE(sizes.back() < behind || behind < sizes.back());
      }
    }
    std::sort(sizes.begin(), sizes.end());
    for (std::size_t k = 1; k < sizes.size(); ++k) {
      EXPECT_TRUE(sizes[k - 1] < sizes[k]);
      EXPECT_LE(sizes[k - 1].squared_circumradius, sizes[k].squared_circumradius);
    }
  }
}

}  // namespace
}  // namespace cocoon
