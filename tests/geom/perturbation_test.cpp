#include "geom/perturbation.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "geom/insphere.h"
#include "geom/orient3d.h"
#include "ref/rational_predicates.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

// The eight corners of a cube, in lexicographic order: all on one sphere.
std::vector<Point> cube(double size) {
  std::vector<Point> corners;
  for (const double x : {0.0, size})
    for (const double y : {0.0, size})
      for (const double z : {0.0, size}) corners.push_back({x, y, z});
  return corners;
}

// All ordered cells of positive orientation with a fifth point, on one sphere.
template <class Visit>
void for_each_cell_and_query(const std::vector<Point>& points, const Visit& visit) {
  for (const Point& a : points)
    for (const Point& b : points)
      for (const Point& c : points)
        for (const Point& d : points)
          if (orient3d(a, b, c, d) == Sign::positive)
            for (const Point& e : points)
              if (e != a && e != b && e != c && e != d) visit(a, b, c, d, e);
}

TEST(InspherePerturbed, KeepsTheSignOffTheSphere) {
  const Point o = {0, 0, 0};
  EXPECT_EQ(insphere_perturbed(o, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}),
            Sign::positive);
  EXPECT_EQ(insphere_perturbed(o, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}), Sign::negative);
}

TEST(InspherePerturbed, HandMadeTies) {
  const Point o = {0, 0, 0};
  const Point x = {1, 0, 0};
  const Point y = {0, 1, 0};
  const Point z = {0, 0, 1};
  // The query is the largest: raised most, so outside.
  EXPECT_EQ(insphere_perturbed(o, x, y, z, {1, 1, 1}), Sign::negative);
  // x is the largest. The coefficient of its lift is orient3d(o, e, y, z) with e = (0, 1, 1): zero,
  // as o, e, y, z are coplanar; then e itself is next.
  EXPECT_EQ(insphere_perturbed(o, x, y, z, {0, 1, 1}), Sign::negative);
  // The mirror image in x: now (1, 0, 0) is the query's side and the cell's vertices rank above it.
  EXPECT_EQ(insphere_perturbed({1, 0, 0}, {0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}),
            orient3d({1, 0, 0}, {0, 0, 0}, {1, 0, 1}, {0, 1, 1}));
}

TEST(InspherePerturbed, IsTheSignOfAnExplicitSmallPerturbation) {
  int ties = 0;
  for_each_cell_and_query(
      cube(1), [&](const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
        if (++ties % 23 != 0) return;  // the rational twin is slow
        ASSERT_EQ(insphere_perturbed(a, b, c, d, e), ref::insphere_perturbed(a, b, c, d, e))
            << a << b << c << d << e;
      });
  EXPECT_GT(ties, 2000);
}

TEST(InspherePerturbed, IsNeverZeroAndIgnoresTheOrderOfTheCell) {
  for (const double size : {1.0, 1e-300, 1e300}) {
    int ties = 0;
    for_each_cell_and_query(cube(size), [&](const Point& a, const Point& b, const Point& c,
                                            const Point& d, const Point& e) {
      ASSERT_EQ(insphere(a, b, c, d, e), Sign::zero);
      const Sign sign = insphere_perturbed(a, b, c, d, e);
      ASSERT_NE(sign, Sign::zero);
      // Even permutations of the cell keep its orientation.
      ASSERT_EQ(insphere_perturbed(b, c, a, d, e), sign);
      ASSERT_EQ(insphere_perturbed(b, a, d, c, e), sign);
      ++ties;
    });
    EXPECT_EQ(ties, 58 * 12 * 4);  // 58 of the 70 quadruples are not coplanar
  }
}

// A perturbation is consistent if it makes one Delaunay triangulation: the cells of the cube whose
// perturbed sphere is empty fill the cube exactly.
TEST(InspherePerturbed, EmptySpheresTriangulateTheCube) {
  const std::vector<Point> points = cube(1);
  double six_volumes = 0;
  int cells = 0;
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = i + 1; j < 8; ++j)
      for (std::size_t k = j + 1; k < 8; ++k)
        for (std::size_t l = k + 1; l < 8; ++l) {
          std::array<Point, 4> p = {points[i], points[j], points[k], points[l]};
          const Sign side = orient3d(p[0], p[1], p[2], p[3]);
          if (side == Sign::zero) continue;
          if (side == Sign::negative) std::swap(p[0], p[1]);
          const bool empty = std::all_of(points.begin(), points.end(), [&](const Point& e) {
            return insphere_perturbed(p[0], p[1], p[2], p[3], e) != Sign::positive;
          });
          if (!empty) continue;
          ++cells;
          six_volumes += dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
        }
  EXPECT_EQ(six_volumes, 6);
  EXPECT_TRUE(cells == 5 || cells == 6) << cells;
}

TEST(InspherePerturbed, IsZeroForAVertexOfTheCell) {
  const std::array<Point, 4> p = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const Point& e : p) EXPECT_EQ(insphere_perturbed(p[0], p[1], p[2], p[3], e), Sign::zero);
}

}  // namespace
}  // namespace cocoon
