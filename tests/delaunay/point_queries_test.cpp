// Location, nearest vertices, stars, elements and Voronoi cells against brute force.
#include "delaunay/point_queries.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/elements.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_cell.h"
#include "delaunay/voronoi_dual.h"
#include "geom/compare_distance.h"
#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/random/random.h"
#include "tests/gallery.h"
#include "tests/named_set.h"

namespace cocoon {
namespace {

class PointQueries : public testing::TestWithParam<NamedSet> {};

// Vertices, midpoints of edges, centroids of facets and cells (exact on integers scaled by 12),
// points around and far away.
std::vector<Point> query_points(const Triangulation& triangulation) {
  Random random(8);
  std::vector<Point> queries;
  for (const Point& p : triangulation.points()) queries.push_back(p);
  for (const CellId c : triangulation.finite_cells()) {
    const Point& p = triangulation.point(triangulation.vertex(c, 0));
    const Point& q = triangulation.point(triangulation.vertex(c, 1));
    const Point& r = triangulation.point(triangulation.vertex(c, 2));
    const Point& s = triangulation.point(triangulation.vertex(c, 3));
    queries.push_back(0.5 * p + 0.5 * q);
    queries.push_back((p + q + r) / 3);
    queries.push_back(0.25 * (p + q + r + s));
  }
  random.shuffle(queries);
  queries.resize(std::min<std::size_t>(queries.size(), 400));
  for (int k = 0; k < 100; ++k) {
    queries.push_back(triangulation.point(VertexId(random.below(triangulation.num_vertices()))) +
                      (k % 2 == 0 ? 0.3 : 30.0) * (random.in_unit_cube() - Point{0.5, 0.5, 0.5}));
  }
  return queries;
}

Sign side(const Triangulation& triangulation, FacetId f, const Point& p) {
  const auto [a, b, c] = triangulation.facet_vertices(f);
  return orient3d(triangulation.point(a), triangulation.point(b), triangulation.point(c), p);
}

TEST_P(PointQueries, LocateAgreesWithASearchOfAllCells) {
  const Triangulation triangulation = delaunay(GetParam().make()).triangulation;
  Random random(2);
  std::set<LocationKind> kinds;
  for (const Point& p : query_points(triangulation)) {
    // The face with p in its interior: the vertices that all cells at p have in common.
    std::vector<VertexId> face;
    bool found = false;
    for (const CellId c : triangulation.finite_cells()) {
      std::vector<VertexId> vertices;
      bool inside = true;
      for (int i = 0; i < 4; ++i) {
        const Sign sign = side(triangulation, facet_id(c, i), p);
        inside = inside && sign != Sign::positive;
        if (sign == Sign::negative) vertices.push_back(triangulation.vertex(c, i));
      }
      if (!inside) continue;
      std::sort(vertices.begin(), vertices.end());
      ASSERT_TRUE(!found || face == vertices);
      face = vertices;
      found = true;
    }
    for (const CellId hint : {CellId(), CellId(random.below(triangulation.num_cells()))}) {
      const Location location = locate(triangulation, p, hint);
      kinds.insert(location.kind);
      if (!found) {
        ASSERT_EQ(location.kind, LocationKind::outside);
        ASSERT_TRUE(triangulation.is_infinite(location.cell));
        ASSERT_EQ(side(triangulation, triangulation.mirror(facet_id(location.cell, 3)), p),
                  Sign::positive);
        continue;
      }
      ASSERT_EQ(static_cast<std::size_t>(location.kind) + 1, face.size());
      for (std::size_t i = 0; i < 4; ++i) {
        ASSERT_EQ(location.vertices[i], i < face.size() ? face[i] : VertexId());
      }
    }
  }
  EXPECT_EQ(kinds.count(LocationKind::vertex), 1U);
  EXPECT_EQ(kinds.count(LocationKind::cell), 1U);
  EXPECT_EQ(kinds.count(LocationKind::outside), 1U);
}

TEST_P(PointQueries, NearestVertexAgreesWithASearchOfAllVertices) {
  const Triangulation triangulation = delaunay(GetParam().make()).triangulation;
  Random random(2);
  for (const Point& p : query_points(triangulation)) {
    VertexId nearest(0);
    for (const VertexId v : triangulation.vertices()) {
      const Point& best = triangulation.point(nearest);
      const Sign sign = compare_distance(p, triangulation.point(v), best);
      if (sign == Sign::negative || (sign == Sign::zero && triangulation.point(v) < best)) {
        nearest = v;
      }
    }
    ASSERT_EQ(nearest_vertex(triangulation, p), nearest);
    ASSERT_EQ(nearest_vertex(triangulation, p, CellId(random.below(triangulation.num_cells()))),
              nearest);
  }
}

TEST_P(PointQueries, StarsAgreeWithTheTableOfAllStars) {
  const Triangulation triangulation = delaunay(GetParam().make()).triangulation;
  const VertexStars stars = vertex_stars(triangulation);
  for (const VertexId v : triangulation.vertices()) {
    std::vector<CellId> star = star_of_vertex(triangulation, v, stars.star(v).back());
    std::sort(star.begin(), star.end());
    const std::span<const CellId> expected = stars.star(v);
    ASSERT_TRUE(std::equal(star.begin(), star.end(), expected.begin(), expected.end()));
  }
}

// Each edge and facet once, and as many as Euler's relation wants: on the sphere at infinity,
// vertices - edges + facets - cells = 0.
TEST_P(PointQueries, ElementsComeOnce) {
  const Triangulation triangulation = delaunay(GetParam().make()).triangulation;
  std::set<std::pair<VertexId, VertexId>> edges;
  for_each_finite_edge(triangulation, [&](VertexId a, VertexId b, FacetId f) {
    ASSERT_LT(a, b);
    ASSERT_TRUE(has_vertex(triangulation.cell(cell_of(f)), a));
    ASSERT_TRUE(edges.insert({a, b}).second);
  });
  std::set<FacetId> facets;
  for_each_finite_facet(triangulation, [&](FacetId f) {
    ASSERT_EQ(triangulation.canonical(f), f);
    ASSERT_TRUE(facets.insert(f).second);
  });
  std::size_t cells = 0;
  for_each_finite_cell(triangulation, [&](CellId c) {
    ASSERT_FALSE(triangulation.is_infinite(c));
    ++cells;
  });
  EXPECT_EQ(cells, triangulation.num_finite_cells());
  EXPECT_EQ(2 * facets.size(),
            4 * cells + (triangulation.num_cells() - triangulation.num_finite_cells()));
  // A ball: vertices - edges + facets - cells = 1.
  EXPECT_EQ(triangulation.num_vertices() + facets.size(), edges.size() + cells + 1);
}

// Bounded cells are closed polyhedra around their vertex: faces have outward normals along the
// edge to the neighbor, and their volumes from the vertex are positive.
TEST_P(PointQueries, VoronoiCellsSurroundTheirVertex) {
  const Triangulation triangulation = delaunay(GetParam().make()).triangulation;
  const VertexStars stars = vertex_stars(triangulation);
  const Dual dual = voronoi_dual(triangulation);
  for (const VertexId v : triangulation.vertices()) {
    const VoronoiCell cell = voronoi_cell(triangulation, v, stars.star(v).front());
    ASSERT_EQ(cell.is_bounded, !is_hull_vertex(triangulation, stars, v));
    const std::vector<VertexId> neighbors =
        neighbors_of_vertex(triangulation, v, stars.star(v).back());
    ASSERT_EQ(cell.faces.size(), neighbors.size());
    std::size_t corners = 0;
    for (std::size_t k = 0; k < neighbors.size(); ++k) {
      const VoronoiFace& face = cell.faces[k];
      ASSERT_EQ(face.neighbor, neighbors[k]);
      ASSERT_GE(face.corners.size(), 3U);
      ASSERT_EQ(face.corners[0], *std::min_element(face.corners.begin(), face.corners.end()));
      corners += face.corners.size();
      const std::size_t infinite = static_cast<std::size_t>(
          std::count_if(face.corners.begin(), face.corners.end(),
                        [&](CellId c) { return triangulation.is_infinite(c); }));
      ASSERT_TRUE(infinite == 0 || infinite == 2);
      if (infinite > 0) continue;
      const Vec3 to_neighbor = triangulation.point(face.neighbor) - triangulation.point(v);
      Vec3 area;
      double extent = 0;
      const Point& first = dual.centers[face.corners[0]];
      for (std::size_t i = 0; i + 1 < face.corners.size(); ++i) {
        const Vec3 p = dual.centers[face.corners[i]] - first;
        const Vec3 q = dual.centers[face.corners[i + 1]] - first;
        area = area + cross(p, q);
        extent = std::max({extent, norm(p), norm(q)});
      }
      // Centers of cospherical vertices differ by rounding only.
      const double rounding = 1e-9 * extent * extent + 1e-14 * extent * (1 + norm(first));
      EXPECT_GE(dot(area, to_neighbor), -rounding * norm(to_neighbor));
    }
    // Each cell at v has three edges at v.
    std::size_t expected = 0;
    for (const CellId c : stars.star(v)) expected += triangulation.is_infinite(c) ? 2 : 3;
    ASSERT_EQ(corners, expected);
  }
}

std::vector<NamedSet> sets() {
  using namespace gallery;
  return {
      {"uniform", [] { return uniform_cube(300); }},
      {"sphere", [] { return sphere(200); }},
      {"grid", [] { return scaled(integer_grid(5), 12); }},
      {"integer_sphere", [] { return integer_sphere(105); }},
      {"box_faces", [] { return box_faces(2); }},
      {"two_lines", [] { return two_lines(12); }},
      {"clusters", [] { return clusters(200); }},
  };
}

INSTANTIATE_TEST_SUITE_P(Gallery, PointQueries, testing::ValuesIn(sets()), name_of);

// The unit cube and its center: by hand.
TEST(VoronoiCell, OfTheCenterOfACubeIsAnOctahedron) {
  std::vector<Point> points = gallery::scaled(gallery::integer_grid(2), 2);
  points.push_back({1, 1, 1});
  const Triangulation triangulation = delaunay(points).triangulation;
  const VertexId center = triangulation.vertex_of_point()[PointId(8)];
  const Location location = locate(triangulation, {1, 1, 1});
  EXPECT_EQ(location.kind, LocationKind::vertex);
  EXPECT_EQ(location.vertices[0], center);
  const VoronoiCell cell = voronoi_cell(triangulation, center, location.cell);
  EXPECT_TRUE(cell.is_bounded);
  EXPECT_EQ(cell.faces.size(), 8U);
  const Dual dual = voronoi_dual(triangulation);
  std::set<Point> corners;
  for (const VoronoiFace& face : cell.faces) {
    for (const CellId c : face.corners) corners.insert(dual.centers[c]);
  }
  EXPECT_EQ(corners.size(), 6U);
}

TEST(PointQueriesOfDynamicDelaunay, AnswerWithoutFreezing) {
  DynamicDelaunay dynamic;
  dynamic.insert(gallery::uniform_cube(500));
  std::vector<VertexId> removed;
  for (int i = 0; i < 400; ++i) removed.push_back(VertexId(i));
  dynamic.remove(removed);
  const FrozenDelaunay frozen = dynamic.freeze();
  for (const Point& p : gallery::uniform_cube(300, 9)) {
    EXPECT_EQ(frozen.frozen_vertex[nearest_vertex(dynamic.view(), p)],
              nearest_vertex(frozen.triangulation, p));
    EXPECT_EQ(locate(dynamic.view(), p).kind, locate(frozen.triangulation, p).kind);
  }
  std::size_t cells = 0;
  for_each_finite_cell(dynamic.view(), [&](CellId) { ++cells; });
  EXPECT_EQ(cells, frozen.triangulation.num_finite_cells());
}

TEST(PointQueriesOfNothing, AreRefused) {
  EXPECT_THROW(locate(Triangulation(), {0, 0, 0}), InputError);
  EXPECT_THROW(nearest_vertex(Triangulation(), {0, 0, 0}), InputError);
  EXPECT_THROW(nearest_vertex(DynamicDelaunay().view(), {0, 0, 0}), InputError);
}

TEST(PointQueriesOfNothing, CellsMustBeThereAndAtTheVertex) {
  const Triangulation t = delaunay(gallery::uniform_cube(50)).triangulation;
  const CellId beyond(t.num_cells());
  EXPECT_THROW(locate(t, {0, 0, 0}, beyond), InputError);
  EXPECT_THROW(nearest_vertex(t, {0, 0, 0}, beyond), InputError);
  EXPECT_THROW(star_of_vertex(t, VertexId(0), beyond), InputError);
  for (const CellId c : t.finite_cells()) {
    const auto& vertices = t.cell(c).vertices;
    if (std::find(vertices.begin(), vertices.end(), VertexId(0)) != vertices.end()) continue;
    EXPECT_THROW(star_of_vertex(t, VertexId(0), c), InputError);
    EXPECT_THROW(neighbors_of_vertex(t, VertexId(0), c), InputError);
    EXPECT_THROW(voronoi_cell(t, VertexId(0), c), InputError);
  }
}

}  // namespace
}  // namespace cocoon
