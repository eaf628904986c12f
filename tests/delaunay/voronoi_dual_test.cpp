#include "delaunay/voronoi_dual.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <span>
#include <vector>

#include "geom/circumsphere.h"
#include "ref/cgal_delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// The corner tetrahedron of the cube: center (1/2, 1/2, 1/2), three axis rays and a diagonal one.
TEST(VoronoiDual, CornerTetrahedron) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Triangulation triangulation = ref::cgal_delaunay(points);
  const Dual dual = voronoi_dual(triangulation);
  EXPECT_EQ(dual.centers[CellId(0)], (Point{0.5, 0.5, 0.5}));
  EXPECT_EQ(dual.facet_fallbacks, 0U);
  std::vector<Vec3> rays;
  for (const CellId c : triangulation.infinite_cells()) rays.push_back(dual.centers[c]);
  std::sort(rays.begin(), rays.end());
  ASSERT_EQ(rays.size(), 4U);
  EXPECT_EQ(rays[0], (Vec3{-1, 0, 0}));
  EXPECT_EQ(rays[1], (Vec3{0, -1, 0}));
  EXPECT_EQ(rays[2], (Vec3{0, 0, -1}));
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(rays[3][axis], std::sqrt(1.0 / 3), 1e-15);
}

TEST(VoronoiDual, CentersAreEquidistantFromTheirVertices) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::uniform_cube(2000, 3));
  const Dual dual = voronoi_dual(triangulation);
  for (const CellId c : triangulation.finite_cells()) {
    const double r = distance(dual.centers[c], triangulation.point(triangulation.vertex(c, 0)));
    for (int i = 1; i < 4; ++i) {
      const double s = distance(dual.centers[c], triangulation.point(triangulation.vertex(c, i)));
      EXPECT_NEAR(r / s, 1, 1e-6);
    }
  }
}

TEST(VoronoiDual, RaysPointOutward) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::uniform_cube(500, 4));
  const Dual dual = voronoi_dual(triangulation);
  for (const CellId c : triangulation.infinite_cells()) {
    const Vec3 ray = dual.centers[c];
    EXPECT_NEAR(norm(ray), 1, 1e-15);
    const Point& on_facet = triangulation.point(triangulation.vertex(c, 0));
    for (const Point& p : triangulation.points()) EXPECT_LE(dot(p - on_facet, ray), 1e-14);
  }
}

TEST(VoronoiDual, SameBitsForEveryThreadCountAndVertexNumbering) {
  std::vector<Point> points = gallery::uniform_cube(20000, 5);
  const Triangulation triangulation = ref::cgal_delaunay(points);
  const Dual one = voronoi_dual(triangulation, {.threads = 1});
  const Dual two = voronoi_dual(triangulation, {.threads = 2});
  EXPECT_EQ(one.centers, two.centers);
  EXPECT_EQ(one.exact_centers, two.exact_centers);

  // The same cells with their vertices rotated in place: still positively oriented.
  IdVector<CellId, Cell> cells = triangulation.cell_records();
  for (const CellId c : triangulation.cells()) {
    auto& [v0, v1, v2, v3] = cells[c].vertices;
    const VertexId first = v0;
    v0 = v1;
    v1 = v2;
    v2 = first;
  }
  const Triangulation rotated({triangulation.points(), cells, triangulation.vertex_of_point()},
                              triangulation.num_finite_cells());
  EXPECT_EQ(voronoi_dual(rotated).centers, one.centers);
}

// Powers of two scale centers exactly and leave directions alone.
TEST(VoronoiDual, ScalingByAPowerOfTwo) {
  const std::vector<Point> points = gallery::uniform_cube(300, 6);
  const Triangulation triangulation = ref::cgal_delaunay(points);
  const Dual dual = voronoi_dual(triangulation);
  for (const double scale : {0x1p-500, 0x1p-60, 0x1p60, 0x1p500}) {
    IdVector<VertexId, Point> scaled = triangulation.points();
    for (Point& p : scaled) p = scale * p;
    const Triangulation copy(
        {scaled, triangulation.cell_records(), triangulation.vertex_of_point()},
        triangulation.num_finite_cells());
    const Dual other = voronoi_dual(copy);
    for (const CellId c : triangulation.finite_cells()) {
      EXPECT_EQ(other.centers[c], scale * dual.centers[c]);
    }
    for (const CellId c : triangulation.infinite_cells()) {
      EXPECT_EQ(other.centers[c], dual.centers[c]);
    }
  }
}

// Cells of points one ulp apart are slivers by the thousand: every center stays finite, and
// the counter tells that floating point did not do.
TEST(VoronoiDual, SliversAreRecomputedExactly) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::ulp_pairs(1000));
  const Dual dual = voronoi_dual(triangulation);
  EXPECT_GT(dual.exact_centers, 0U);
  EXPECT_EQ(dual.facet_fallbacks, 0U);
  for (const CellId c : triangulation.cells()) {
    EXPECT_TRUE(is_finite(dual.centers[c]));
    if (triangulation.is_infinite(c)) {
      EXPECT_NEAR(norm(dual.centers[c]), 1, 1e-15);
      continue;
    }
    // The relative error of a distance is that of the center over its distance.
    const double scale = std::max(1.0, norm(dual.centers[c]));
    const double r = distance(dual.centers[c], triangulation.point(triangulation.vertex(c, 0)));
    for (int i = 1; i < 4; ++i) {
      const double s = distance(dual.centers[c], triangulation.point(triangulation.vertex(c, i)));
      EXPECT_NEAR(r, s, 1e-6 * r + 1e-15 * scale);
    }
  }
}

// The cells of a grid are cospherical in eights: one center for all.
TEST(VoronoiDual, GridHasOneCenterPerCube) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::integer_grid(5));
  const Dual dual = voronoi_dual(triangulation);
  std::set<Point> centers;
  for (const CellId c : triangulation.finite_cells()) centers.insert(dual.centers[c]);
  std::set<Point> expected;
  for (const Point& p : gallery::integer_grid(4)) expected.insert(p + Vec3{0.5, 0.5, 0.5});
  EXPECT_EQ(centers, expected);
}

// Each cell by itself, and those that floating point could not decide, on the worst sets there are.
TEST(VoronoiDual, CellsOneByOne) {
  const std::vector<std::vector<Point>> sets{gallery::uniform_cube(500, 7), gallery::ulp_pairs(200),
                                             gallery::even_sphere(800)};
  std::size_t undecided = 0;
  for (const std::vector<Point>& points : sets) {
    const Triangulation triangulation = ref::cgal_delaunay(points);
    const Dual dual = voronoi_dual(triangulation, {.threads = 2});
    for (const CellId c : triangulation.cells()) {
      EXPECT_EQ(voronoi_vertex(triangulation, c), dual.centers[c]);
    }
    EXPECT_EQ(dual.not_in_doubles.size(), dual.exact_centers + dual.facet_fallbacks);
    EXPECT_TRUE(std::is_sorted(dual.not_in_doubles.begin(), dual.not_in_doubles.end()));
    for (const CellId c : dual.not_in_doubles) {
      if (triangulation.is_infinite(c)) continue;
      const auto& [p, q, r, s] = triangulation.cell(c).vertices;
      EXPECT_NE(circumcenter(triangulation.point(p), triangulation.point(q), triangulation.point(r),
                             triangulation.point(s))
                    .level,
                CenterLevel::doubles);
    }
    undecided += dual.not_in_doubles.size();
  }
  EXPECT_GT(undecided, 0U);
}

TEST(VoronoiDual, EdgesFromBothSidesAgree) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::uniform_cube(100, 8));
  const Dual dual = voronoi_dual(triangulation);
  std::size_t rays = 0;
  for (const CellId c : triangulation.cells()) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (!triangulation.is_finite_facet(f)) continue;
      const DualEdge edge = dual_edge(triangulation, dual, f);
      const DualEdge back = dual_edge(triangulation, dual, triangulation.mirror(f));
      EXPECT_EQ(edge.is_ray, back.is_ray);
      if (edge.is_ray) {
        ++rays;
        EXPECT_EQ(edge.from, back.from);
        EXPECT_EQ(edge.to, back.to);
      } else {
        EXPECT_EQ(edge.from, back.to);
        EXPECT_EQ(edge.to, back.from);
      }
    }
  }
  // Once from each side of every hull facet.
  EXPECT_EQ(rays, 2 * (triangulation.num_cells() - triangulation.num_finite_cells()));
}

}  // namespace
}  // namespace cocoon
