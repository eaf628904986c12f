#include "geom/mesh/split_nonmanifold.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "cocone/mark_cells.h"
#include "cocone/reconstruct.h"
#include "cocone/surface_mesh.h"
#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "geom/mesh/weld_vertices.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

void expect_same_surface(const SplitSurface& split, const TriangleMesh& mesh) {
  ASSERT_EQ(split.source.size(), split.mesh.points.size());
  EXPECT_EQ(split.mesh.points.size(), mesh.points.size() + split.copies + split.midpoints);
  EXPECT_EQ(split.mesh.triangles.size(), mesh.triangles.size() + 2 * split.midpoints);
  for (const VertexId v : split.mesh.points.ids()) {
    const VertexId source = split.source[v];
    const bool is_midpoint = v.index() >= mesh.points.size() + split.copies;
    EXPECT_TRUE(is_midpoint || split.mesh.points[v] == mesh.points[source]);
    EXPECT_TRUE(v.index() >= mesh.points.size() || source == v);
  }
  const MeshMeasure before = mesh_measure(mesh);
  const MeshMeasure after = mesh_measure(split.mesh);
  EXPECT_NEAR(after.area, before.area, 1e-12 * before.area);
  EXPECT_NEAR(after.signed_volume, before.signed_volume, 1e-12 * before.area);
}

TEST(SplitNonmanifold, LeavesManifoldsAlone) {
  for (TriangleMesh mesh : {gallery::tetrahedron(), gallery::cube()}) {
    canonicalize_triangles(mesh);
    const SplitSurface split = split_nonmanifold(mesh);
    EXPECT_EQ(split.mesh, mesh);
    EXPECT_EQ(split.split_edges + split.split_vertices + split.copies + split.midpoints, 0U);
  }
  EXPECT_TRUE(split_nonmanifold({}).mesh.triangles.empty());
}

// Two tetrahedra that meet in one vertex, or along one edge, come apart.
TEST(SplitNonmanifold, TetrahedraThatTouch) {
  const TriangleMesh vertex = gallery::two_tetrahedra_sharing_a_vertex();
  const SplitSurface at_vertex = split_nonmanifold(vertex);
  EXPECT_TRUE(mesh_check(at_vertex.mesh).is_closed_manifold());
  EXPECT_EQ(at_vertex.split_vertices, 1U);
  EXPECT_EQ(at_vertex.copies, 1U);
  EXPECT_EQ(at_vertex.split_edges, 0U);
  expect_same_surface(at_vertex, vertex);

  const TriangleMesh edge = gallery::two_tetrahedra_sharing_an_edge();
  ASSERT_TRUE(mesh_check(edge).balanced);
  const SplitSurface at_edge = split_nonmanifold(edge);
  const MeshReport report = mesh_check(at_edge.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(at_edge.split_edges, 1U);
  EXPECT_EQ(at_edge.split_vertices, 2U);
  EXPECT_EQ(at_edge.midpoints, 0U);
  expect_same_surface(at_edge, edge);
}

// The boundary of a set of cells.
TriangleMesh boundary_of(const Triangulation& triangulation, IdVector<CellId, std::uint8_t> out) {
  CellMarks marks;
  marks.reached = std::move(out);
  return surface_between(triangulation, marks).mesh;
}

// 3 x 3 x 3 cubes without two of the middle layer that meet in a vertical edge, opened to one side:
// the body goes on above and below that edge, so each end of it has a single fan that passes the
// edge twice, and copies of the ends would not part the two pairs there.
TEST(SplitNonmanifold, SeamsGetMidpoints) {
  const auto points = gallery::integer_grid(4);
  const Triangulation triangulation = delaunay(points).triangulation;
  IdVector<CellId, std::uint8_t> out(triangulation.num_cells(), 1);
  for (const CellId c : triangulation.finite_cells()) {
    Point center;
    for (int i = 0; i < 4; ++i) {
      center = center + 0.25 * triangulation.point(triangulation.vertex(c, i));
    }
    const bool edge_gap = center.z > 1 && center.z < 2 && center.x > 1 && center.y > 1 &&
                          (center.x > 2) != (center.y > 2);
    const bool tunnel = center.z > 1 && center.z < 2 && (center.x < 1 || center.y < 1);
    out[c] = edge_gap || tunnel ? 1 : 0;
  }
  const TriangleMesh mesh = boundary_of(triangulation, std::move(out));
  ASSERT_EQ(mesh_check(mesh).overfull_edges, 1U);
  const SplitSurface split = split_nonmanifold(mesh);
  EXPECT_EQ(split.split_edges, 1U);
  EXPECT_EQ(split.midpoints, 1U);
  // The edge is one of the grid, upwards: its midpoint stands for the lower end.
  const VertexId midpoint(split.mesh.points.size() - 1);
  EXPECT_EQ(split.mesh.points[midpoint], (Point{2, 2, 1.5}));
  EXPECT_EQ(mesh.points[split.source[midpoint]], (Point{2, 2, 1}));
  EXPECT_TRUE(mesh_check(split.mesh).is_closed_manifold());
  expect_same_surface(split, mesh);
}

// Every second cell taken at random: as bad as boundaries of bodies get.
TEST(SplitNonmanifold, BoundariesOfRandomBodiesBecomeManifolds) {
  Random random(3);
  std::size_t edges = 0;
  std::size_t midpoints = 0;
  for (const auto& points :
       {gallery::uniform_cube(12, 1), gallery::uniform_cube(300, 2), gallery::integer_grid(6),
        gallery::integer_sphere(41), gallery::two_lines(12), gallery::ulp_grids(4, 3),
        gallery::plane_and_apex(8), gallery::scaled(gallery::uniform_cube(100, 4), 0x1p-300),
        gallery::shifted(gallery::uniform_cube(100, 5), {1e6, -1e6, 1e6})}) {
    const Triangulation triangulation = delaunay(points).triangulation;
    for (const double density : {0.1, 0.5, 0.9}) {
      IdVector<CellId, std::uint8_t> out(triangulation.num_cells(), 1);
      for (const CellId c : triangulation.finite_cells()) {
        out[c] = random.uniform() < density ? 0 : 1;
      }
      const TriangleMesh mesh = boundary_of(triangulation, out);
      if (mesh.triangles.empty()) continue;
      const SplitSurface split = split_nonmanifold(mesh);
      EXPECT_TRUE(mesh_check(split.mesh).is_closed_manifold()) << points.size();
      EXPECT_EQ(split.split_edges, mesh_check(mesh).overfull_edges);
      EXPECT_EQ(split.unpaired_halfedges, 0U);
      EXPECT_EQ(split.mesh.points.size(), mesh.points.size() + split.copies + split.midpoints);
      edges += split.split_edges;
      midpoints += split.midpoints;
    }
  }
  EXPECT_GT(edges, 1000U);
  EXPECT_GT(midpoints, 10U);
}

// Then two triangles at an edge may run through it in the same direction.
TEST(SplitNonmanifold, TrianglesTurnedAtRandomBecomeManifolds) {
  Random random(8);
  std::size_t midpoints = 0;
  for (const auto& points : {gallery::uniform_cube(300, 2), gallery::integer_grid(6)}) {
    const Triangulation triangulation = delaunay(points).triangulation;
    IdVector<CellId, std::uint8_t> out(triangulation.num_cells(), 1);
    for (const CellId c : triangulation.finite_cells()) out[c] = random.below(2) == 0 ? 0 : 1;
    TriangleMesh mesh = boundary_of(triangulation, out);
    for (Triangle& t : mesh.triangles) {
      if (random.below(3) == 0) std::swap(t[0], t[1]);
    }
    const SplitSurface split = split_nonmanifold(mesh);
    const MeshReport report = mesh_check(split.mesh);
    EXPECT_TRUE(report.edge_manifold && report.vertex_manifold);
    EXPECT_GE(report.open_edges, split.unpaired_halfedges);  // midpoints cut some in two
    const double area = mesh_measure(mesh).area;
    EXPECT_NEAR(mesh_measure(split.mesh).area, area, 1e-12 * area);
    midpoints += split.midpoints;
  }
  EXPECT_GT(midpoints, 10U);
}

// What the reconstruction makes of points that are samples of no surface.
TEST(SplitNonmanifold, SurfacesOfRubbishBecomeManifolds) {
  std::size_t edges = 0;
  std::vector<std::vector<Point>> sets{gallery::integer_grid(7), gallery::clusters(800),
                                       gallery::box_faces(3),    gallery::cylinder(6),
                                       gallery::two_lines(40),   shapes::plate(15, 1)};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    sets.push_back(shapes::random_cube(200 * seed, seed));
    sets.push_back(shapes::noisy_sphere(700, 0.05, seed));
  }
  for (const std::vector<Point>& points : sets) {
    for (const Mode mode : {Mode::paper, Mode::robust}) {
      const TriangleMesh tight = reconstruct_tight(points, {.mode = mode}).mesh;
      const SplitSurface split = split_nonmanifold(tight);
      edges += split.split_edges;
      EXPECT_EQ(split.unpaired_halfedges, 0U);
      EXPECT_TRUE(tight.triangles.empty() || mesh_check(split.mesh).is_closed_manifold());
    }
    const MeshReport open = mesh_check(split_nonmanifold(reconstruct_cocone(points).mesh).mesh);
    EXPECT_TRUE(open.edge_manifold && open.vertex_manifold);
  }
  EXPECT_GT(edges, 100U);
}

// The same surface with its vertices and triangles in another order.
TEST(SplitNonmanifold, DoesNotDependOnTheOrder) {
  Random random(4);
  const Triangulation triangulation =
      canonical_order(delaunay(gallery::uniform_cube(300, 6)).triangulation);
  IdVector<CellId, std::uint8_t> out(triangulation.num_cells(), 1);
  for (const CellId c : triangulation.finite_cells()) out[c] = random.uniform() < 0.5 ? 0 : 1;
  const TriangleMesh mesh = boundary_of(triangulation, out);
  std::vector<VertexId> order;
  for (const VertexId v : mesh.points.ids()) order.push_back(v);
  random.shuffle(order);
  TriangleMesh other;
  other.points.resize(order.size());
  for (const VertexId v : mesh.points.ids()) other.points[order[v.index()]] = mesh.points[v];
  for (const auto& [a, b, c] : mesh.triangles) {
    other.triangles.push_back({order[b.index()], order[c.index()], order[a.index()]});
  }
  random.shuffle(other.triangles.raw());
  const SplitSurface split = split_nonmanifold(mesh);
  const SplitSurface other_split = split_nonmanifold(other);
  EXPECT_GT(split.midpoints, 0U);
  const auto soup = [](const TriangleMesh& surface) {
    std::vector<std::array<Point, 3>> triangles;
    for (const Triangle& t : surface.triangles) {
      std::array<Point, 3> corners{surface.points[t[0]], surface.points[t[1]],
                                   surface.points[t[2]]};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  EXPECT_EQ(soup(split.mesh), soup(other_split.mesh));
  EXPECT_EQ(split.copies, other_split.copies);
}

// Cubes of a grid, each a closed surface of its own: where two are neighbors, facets coincide.
TriangleMesh touching_cubes(int count, bool share_vertices, std::uint64_t seed) {
  Random random(seed);
  TriangleMesh mesh;
  for (const Point& corner : gallery::integer_grid(count)) {
    if (random.uniform() < 0.5)
      mesh = gallery::join(mesh, gallery::translated(gallery::cube(), corner));
  }
  if (share_vertices) mesh = weld_vertices(mesh, repeated_points(mesh.points.raw())).mesh;
  return mesh;
}

// Coincident facets that run against each other part the inside, whatever their numbers.
TEST(SplitNonmanifold, TouchingBodiesAreParted) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const TriangleMesh mesh = touching_cubes(3, true, seed);
    const std::size_t bodies = touching_cubes(3, false, seed).points.size() / 8;
    for (unsigned order = 1; order <= 5; ++order) {
      const SplitSurface split = split_nonmanifold(gallery::shuffled(mesh, order));
      const MeshReport report = mesh_check(split.mesh);
      EXPECT_TRUE(report.is_closed_manifold()) << seed;
      EXPECT_EQ(report.components, bodies) << seed << ' ' << order;
      EXPECT_EQ(split.midpoints, 0U) << seed << ' ' << order;
    }
  }
}

// Two tetrahedra with an edge in common and facets in one half-plane from it, one inside the other
// there: which facets bound one wedge does not depend on what the ends of the edge are called.
TEST(SplitNonmanifold, FacetsInOneHalfPlane) {
  const TriangleMesh mesh = gallery::make_mesh(
      {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.25}, {2, 0, 0.5}, {1, 2, 0.5}, {2, 1, 0.5}},
      {{1, 2, 4}, {0, 4, 2}, {0, 1, 4}, {0, 2, 1}, {1, 3, 5}, {0, 5, 3}, {0, 1, 5}, {0, 3, 1}});
  const SplitSurface expected = split_nonmanifold(mesh);
  EXPECT_TRUE(mesh_check(expected.mesh).is_closed_manifold());
  for (unsigned order = 1; order <= 20; ++order) {
    const SplitSurface split = split_nonmanifold(gallery::shuffled(mesh, order));
    EXPECT_EQ(split.copies, expected.copies) << order;
    EXPECT_EQ(mesh_check(split.mesh).components, mesh_check(expected.mesh).components) << order;
  }
}

// Where as many triangles do not run each way, sides stay open; three sheets at one edge.
TEST(SplitNonmanifold, SheetsWithoutPartnerStayOpen) {
  const TriangleMesh fan = gallery::make_mesh(
      {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const SplitSurface split = split_nonmanifold(fan);
  const MeshReport report = mesh_check(split.mesh);
  EXPECT_EQ(split.unpaired_halfedges, 1U);
  EXPECT_EQ(report.overfull_edges, 0U);
  EXPECT_EQ(report.pinched_vertices, 0U);
  EXPECT_THROW(split_nonmanifold(gallery::make_mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}})),
               InputError);
}

}  // namespace
}  // namespace cocoon
