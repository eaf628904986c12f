#include "geom/mesh_check.h"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "geom/mesh_measure.h"
#include "ref/cgal_mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using gallery::make_mesh;

void expect_closed_manifold(const TriangleMesh& mesh, std::size_t genus) {
  const MeshReport report = mesh_check(mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_TRUE(report.watertight && report.balanced && report.edge_manifold &&
              report.vertex_manifold && report.oriented && report.orientable);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.vertex_components, 1U);
  EXPECT_EQ(report.euler, 2 - 2 * static_cast<std::ptrdiff_t>(genus));
  ASSERT_TRUE(report.genus.has_value());
  EXPECT_EQ(*report.genus, genus);
  EXPECT_EQ(report.open_edges + report.overfull_edges + report.pinched_vertices +
                report.orientation_conflicts + report.zero_area_triangles +
                report.duplicate_triangles + report.coincident_vertices + report.unused_vertices,
            0U);
  EXPECT_EQ(2 * report.edges, 3 * report.triangles);
}

TEST(MeshCheck, ClosedManifolds) {
  expect_closed_manifold(gallery::tetrahedron(), 0);
  expect_closed_manifold(gallery::cube(), 0);
  expect_closed_manifold(gallery::sphere(3), 0);
  expect_closed_manifold(gallery::torus(8, 6), 1);
  expect_closed_manifold(gallery::flipped(gallery::torus(8, 6)), 1);
}

TEST(MeshCheck, OpenPatch) {
  const MeshReport report = mesh_check(gallery::open_patch(3, 4));
  EXPECT_FALSE(report.watertight);
  EXPECT_FALSE(report.balanced);
  EXPECT_TRUE(report.edge_manifold && report.vertex_manifold && report.oriented);
  EXPECT_EQ(report.open_edges, 14U);
  EXPECT_EQ(report.odd_edges, 14U);
  EXPECT_EQ(report.unbalanced_edges, 14U);
  EXPECT_EQ(report.boundary_curves, 1U);
  EXPECT_EQ(report.euler, 1);
  EXPECT_FALSE(report.genus.has_value());
  EXPECT_EQ(report.examples.open_edges.size(), 8U);
  EXPECT_EQ(report.examples.open_edges[0], (VertexPair{VertexId(0), VertexId(1)}));
}

TEST(MeshCheck, PatchWithAHoleHasTwoBoundaryCurves) {
  TriangleMesh mesh = gallery::open_patch(3, 3);
  std::vector<Triangle>& triangles = mesh.triangles.raw();
  triangles.erase(triangles.begin() + 8, triangles.begin() + 10);  // the middle quad
  const MeshReport report = mesh_check(mesh);
  EXPECT_EQ(report.boundary_curves, 2U);
  EXPECT_EQ(report.open_edges, 16U);
  EXPECT_EQ(report.euler, 0);
}

TEST(MeshCheck, TetrahedraSharingAVertexArePinchedThere) {
  const MeshReport report = mesh_check(gallery::two_tetrahedra_sharing_a_vertex());
  EXPECT_TRUE(report.watertight && report.balanced && report.edge_manifold && report.oriented);
  EXPECT_FALSE(report.vertex_manifold);
  EXPECT_FALSE(report.is_closed_manifold());
  ASSERT_EQ(report.pinched_vertices, 1U);
  EXPECT_EQ(report.examples.pinched_vertices[0], VertexId(0));
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(report.vertex_components, 1U);
  EXPECT_EQ(report.euler, 3);
  EXPECT_FALSE(report.genus.has_value());
}

TEST(MeshCheck, TetrahedraSharingAnEdgeAreBalancedThere) {
  const MeshReport report = mesh_check(gallery::two_tetrahedra_sharing_an_edge());
  EXPECT_TRUE(report.watertight && report.balanced && report.oriented);
  EXPECT_FALSE(report.edge_manifold);
  ASSERT_EQ(report.overfull_edges, 1U);
  EXPECT_EQ(report.examples.overfull_edges[0], (VertexPair{VertexId(0), VertexId(1)}));
  EXPECT_EQ(report.pinched_vertices, 2U);
  EXPECT_EQ(report.odd_edges, 0U);
  EXPECT_EQ(report.components, 1U);
  EXPECT_FALSE(report.component_reports[0].closed);
  EXPECT_FALSE(report.component_reports[0].manifold);
}

TEST(MeshCheck, FlippedTriangleConflictsWithItsThreeNeighbors) {
  TriangleMesh mesh = gallery::cube();
  std::swap(mesh.triangles[TriangleId(4)][0], mesh.triangles[TriangleId(4)][1]);
  const MeshReport report = mesh_check(mesh);
  EXPECT_TRUE(report.watertight);
  EXPECT_FALSE(report.balanced);
  EXPECT_FALSE(report.oriented);
  EXPECT_TRUE(report.orientable);
  EXPECT_EQ(report.orientation_conflicts, 3U);
  EXPECT_EQ(report.unbalanced_edges, 3U);
  EXPECT_EQ(report.genus, 0U);  // genus belongs to the surface, not to its orientation
  EXPECT_FALSE(report.is_closed_manifold());
}

TEST(MeshCheck, MoebiusStripIsNotOrientable) {
  for (const int quads : {3, 4, 5, 8}) {
    const MeshReport report = mesh_check(gallery::moebius_strip(quads));
    EXPECT_FALSE(report.orientable) << quads;
    EXPECT_GT(report.orientation_conflicts, 0U) << quads;
    EXPECT_EQ(report.boundary_curves, 1U) << quads;
    EXPECT_EQ(report.euler, 0) << quads;
    EXPECT_TRUE(report.edge_manifold && report.vertex_manifold) << quads;
  }
}

TEST(MeshCheck, ProjectivePlaneIsClosedButHasNoGenus) {
  const MeshReport report = mesh_check(gallery::projective_plane());
  EXPECT_TRUE(report.watertight && report.edge_manifold && report.vertex_manifold);
  EXPECT_FALSE(report.orientable);
  EXPECT_FALSE(report.balanced);
  EXPECT_EQ(report.euler, 1);
  EXPECT_FALSE(report.genus.has_value());
}

TEST(MeshCheck, GenusIsTheSumOverComponents) {
  const TriangleMesh torus = gallery::torus(6, 5);
  const TriangleMesh far_torus = gallery::translated(torus, {10, 0, 0});
  const MeshReport report =
      mesh_check(gallery::join(gallery::join(torus, far_torus), gallery::tetrahedron()));
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 3U);
  EXPECT_EQ(report.vertex_components, 3U);
  EXPECT_EQ(report.genus, 2U);
  EXPECT_EQ(report.euler, 2);
  ASSERT_EQ(report.component_reports.size(), 3U);
  EXPECT_EQ(report.component_reports[1].first_triangle, TriangleId(60));
  EXPECT_EQ(report.component_reports[1].genus, 1U);
  EXPECT_EQ(report.component_reports[2].triangles, 4U);
  EXPECT_EQ(report.component_reports[2].vertices, 4U);
  EXPECT_EQ(report.component_reports[2].edges, 6U);
}

TEST(MeshCheck, FinIsNoOrientationConflictButOdd) {
  // Three triangles at one edge.
  const MeshReport report = mesh_check(make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(report.overfull_edges, 1U);
  EXPECT_EQ(report.open_edges, 6U);
  EXPECT_EQ(report.odd_edges, 7U);
  EXPECT_EQ(report.orientation_conflicts, 0U);
  EXPECT_FALSE(report.oriented);
  EXPECT_EQ(report.components, 1U);
}

TEST(MeshCheck, BadTrianglesAreCountedAndNamed) {
  const TriangleMesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {5, 5, 5}},
                                      {{0, 1, 3}, {0, 1, 1}, {0, 1, 2}, {1, 3, 0}, {3, 1, 0}});
  const MeshReport report = mesh_check(mesh);
  EXPECT_EQ(report.triangles, 5U);
  EXPECT_EQ(report.repeated_vertex_triangles, 1U);
  EXPECT_EQ(report.examples.repeated_vertex_triangles, std::vector{TriangleId(1)});
  EXPECT_EQ(report.zero_area_triangles, 1U);
  EXPECT_EQ(report.examples.zero_area_triangles, std::vector{TriangleId(2)});
  EXPECT_EQ(report.duplicate_triangles, 2U);
  EXPECT_EQ(report.examples.duplicate_triangles, (std::vector{TriangleId(3), TriangleId(4)}));
  EXPECT_EQ(report.used_vertices, 4U);
  EXPECT_EQ(report.unused_vertices, 1U);
}

TEST(MeshCheck, ZeroAreaIsExact) {
  const double tiny = std::numeric_limits<double>::epsilon();
  const TriangleMesh sliver = make_mesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2 + 2 * tiny}}, {{0, 1, 2}});
  EXPECT_EQ(mesh_check(sliver).zero_area_triangles, 0U);
  const TriangleMesh flat = make_mesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}});
  EXPECT_EQ(mesh_check(flat).zero_area_triangles, 1U);
}

TEST(MeshCheck, CoincidentAndNonFiniteVertices) {
  TriangleMesh mesh = gallery::join(gallery::tetrahedron(), gallery::tetrahedron());
  EXPECT_EQ(mesh_check(mesh).coincident_vertices, 4U);
  mesh.points[VertexId(6)].y = std::numeric_limits<double>::quiet_NaN();
  const MeshReport report = mesh_check(mesh);
  EXPECT_EQ(report.non_finite_vertices, 1U);
  EXPECT_EQ(report.examples.non_finite_vertices, std::vector{VertexId(6)});
  EXPECT_EQ(report.coincident_vertices, 3U);
}

TEST(MeshCheck, TwoTrianglesBackToBackAreADuplicateButClosed) {
  const MeshReport report =
      mesh_check(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}));
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.duplicate_triangles, 1U);
  EXPECT_EQ(report.euler, 2);
}

TEST(MeshCheck, EmptyMeshIsNotWatertight) {
  TriangleMesh mesh;
  mesh.points.push_back({1, 2, 3});
  const MeshReport report = mesh_check(mesh);
  EXPECT_FALSE(report.watertight);
  EXPECT_FALSE(report.balanced);
  EXPECT_FALSE(report.genus.has_value());
  EXPECT_EQ(report.unused_vertices, 1U);
  EXPECT_EQ(report.components, 0U);
}

TEST(MeshCheck, CountsDoNotDependOnOrderOrPlace) {
  for (const TriangleMesh& mesh :
       {gallery::torus(7, 5), gallery::open_patch(4, 3), gallery::moebius_strip(5),
        gallery::two_tetrahedra_sharing_an_edge(), gallery::two_tetrahedra_sharing_a_vertex()}) {
    const MeshReport expected = mesh_check(mesh);
    for (const unsigned seed : {1U, 2U, 3U}) {
      const TriangleMesh moved =
          gallery::scaled(gallery::quarter_turned(gallery::shuffled(mesh, seed)), 0x1p-20);
      const MeshReport actual = mesh_check(moved);
      EXPECT_EQ(actual.open_edges, expected.open_edges);
      EXPECT_EQ(actual.overfull_edges, expected.overfull_edges);
      EXPECT_EQ(actual.pinched_vertices, expected.pinched_vertices);
      EXPECT_EQ(actual.components, expected.components);
      EXPECT_EQ(actual.vertex_components, expected.vertex_components);
      EXPECT_EQ(actual.boundary_curves, expected.boundary_curves);
      EXPECT_EQ(actual.euler, expected.euler);
      EXPECT_EQ(actual.genus, expected.genus);
      EXPECT_EQ(actual.orientable, expected.orientable);
      EXPECT_EQ(actual.orientation_conflicts, expected.orientation_conflicts);
      EXPECT_EQ(actual.zero_area_triangles, expected.zero_area_triangles);
    }
  }
}

TEST(MeshCheck, AgreesWithCgal) {
  TriangleMesh flipped_triangle = gallery::cube();
  std::swap(flipped_triangle.triangles[TriangleId(4)][0],
            flipped_triangle.triangles[TriangleId(4)][1]);
  for (const TriangleMesh& mesh :
       {gallery::cube(), gallery::sphere(2), gallery::torus(7, 5), gallery::open_patch(4, 3),
        gallery::join(gallery::torus(7, 5), gallery::open_patch(2, 2)), flipped_triangle,
        gallery::moebius_strip(5), gallery::projective_plane(), gallery::random_soup(20, 1),
        gallery::two_tetrahedra_sharing_an_edge(), gallery::two_tetrahedra_sharing_a_vertex()}) {
    const MeshReport report = mesh_check(mesh);
    const bool proper = report.edge_manifold && report.vertex_manifold && report.oriented;
    const auto cgal = ref::cgal_mesh_check(mesh);
    ASSERT_EQ(cgal.has_value(), proper);
    if (!cgal) continue;
    EXPECT_EQ(cgal->closed, report.is_closed_manifold());
    EXPECT_EQ(cgal->components, report.components);
    EXPECT_EQ(cgal->boundary_cycles, report.boundary_curves);
    const MeshMeasure measure = mesh_measure(mesh);
    EXPECT_NEAR(cgal->area, measure.area, 1e-13 * measure.area);
    if (cgal->closed) {
      EXPECT_NEAR(cgal->volume, measure.signed_volume, 1e-13 * measure.area);
    }
  }
}

TEST(MeshCheck, RefusesATriangleThatNamesAMissingVertex) {
  TriangleMesh mesh = gallery::tetrahedron();
  mesh.triangles[TriangleId(2)][1] = VertexId(4);
  EXPECT_THROW(mesh_check(mesh), InputError);
}

// With a walk around the edge for each of its triangles this takes a minute.
TEST(MeshCheck, AnEdgeOfManyTrianglesTakesNoMoreThanThese) {
  constexpr std::size_t pages = 200000;
  TriangleMesh book;
  book.points.push_back({0, 0, 0});
  book.points.push_back({0, 0, 1});
  for (std::size_t k = 0; k < pages; ++k) {
    book.points.push_back({1, static_cast<double>(k), 0.5});
    book.triangles.push_back({VertexId(0U), VertexId(1U), VertexId(k + 2)});
  }
  const auto start = std::chrono::steady_clock::now();
  const MeshReport report = mesh_check(book);
  EXPECT_EQ(mesh_measure(book).edge_lengths.count, report.edges);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));
  EXPECT_EQ(report.edges, 2 * pages + 1);
  EXPECT_EQ(report.overfull_edges, 1U);
  EXPECT_EQ(report.open_edges, 2 * pages);
}

}  // namespace
// Short links are walked, long ones are not: a hub with any number of spokes around the limit.
TEST(MeshCheck, JudgesLinksOfEveryLength) {
  for (std::uint32_t spokes = 5; spokes < 40; ++spokes) {
    const auto fan = [spokes](const std::vector<std::uint32_t>& missing) {
      TriangleMesh mesh;
      mesh.points.push_back({0, 0, 1});
      for (std::uint32_t k = 0; k <= spokes; ++k) mesh.points.push_back({1.0 * k, 1.0 * k * k, 0});
      for (std::uint32_t i = 0; i < spokes; ++i) {
        const std::uint32_t k = (i * (spokes - 1) + 2) % spokes;  // not in the order of the fan
        if (std::count(missing.begin(), missing.end(), k) != 0) continue;
        mesh.triangles.push_back({VertexId(0), VertexId(1 + k), VertexId(1 + (k + 1) % spokes)});
      }
      return mesh;
    };
    const auto pinched = [](const TriangleMesh& mesh) {
      const MeshReport report = mesh_check(mesh);
      return !report.examples.pinched_vertices.empty() &&
             report.examples.pinched_vertices[0] == VertexId(0);
    };
    EXPECT_FALSE(pinched(fan({}))) << spokes;
    EXPECT_FALSE(pinched(fan({1}))) << spokes;
    EXPECT_FALSE(pinched(fan({1, 2}))) << spokes;
    EXPECT_TRUE(pinched(fan({1, 3}))) << spokes;
    TriangleMesh branched = fan({});
    branched.triangles.push_back({VertexId(0), VertexId(3), VertexId(spokes + 1)});
    EXPECT_TRUE(pinched(branched)) << spokes;
  }
}

// A fin on a surface that is not orientable hangs together with it, whichever comes first.
TEST(MeshCheck, AFinMakesNothingOrientable) {
  TriangleMesh mesh = gallery::projective_plane();
  const VertexId tip = mesh.points.push_back({0, 0, 7});
  mesh.triangles.push_back({VertexId(0), VertexId(1), tip});
  for (int round = 0; round < 2; ++round) {
    const MeshReport report = mesh_check(mesh);
    EXPECT_EQ(report.overfull_edges, 1U);
    ASSERT_EQ(report.component_reports.size(), 1U);
    EXPECT_FALSE(report.orientable);
    EXPECT_FALSE(report.component_reports[0].orientable);
    EXPECT_FALSE(report.component_reports[0].manifold);
    std::rotate(mesh.triangles.begin(), mesh.triangles.end() - 1, mesh.triangles.end());
  }
}

// Whichever corner is at infinity: there is no telling whether it has area.
TEST(MeshCheck, ATriangleToInfinityIsNotCountedAsFlat) {
  for (const std::size_t corner : {0U, 1U, 2U}) {
    TriangleMesh mesh = gallery::tetrahedron();
    mesh.triangles.resize(1);
    Point& p = mesh.points[mesh.triangles[TriangleId(0)][corner]];
    for (const double x :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
      p.x = x;
      EXPECT_EQ(mesh_check(mesh).zero_area_triangles, 0U) << corner;
    }
  }
}

TEST(MeshCheck, ComponentsComeInTheOrderOfTheirFirstTriangles) {
  const MeshReport report = mesh_check(gallery::join(gallery::tetrahedron(), gallery::torus(9, 7)));
  ASSERT_EQ(report.component_reports.size(), 2U);
  EXPECT_EQ(report.component_reports[0].triangles, 4U);
  EXPECT_EQ(report.component_reports[1].first_triangle, TriangleId(4));
}

TEST(MeshCheck, PlacesAtInfinityDoNotCoincide) {
  TriangleMesh mesh = gallery::tetrahedron();
  for (int k = 0; k < 2; ++k) {
    mesh.points.push_back({std::numeric_limits<double>::infinity(), 0, 0});
  }
  const MeshReport report = mesh_check(mesh);
  EXPECT_EQ(report.non_finite_vertices, 2U);
  EXPECT_EQ(report.coincident_vertices, 0U);
}

}  // namespace cocoon
