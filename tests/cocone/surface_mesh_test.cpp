#include "cocone/surface_mesh.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/facets/linked_facets.h"
#include "tests/cocone/octahedron.h"

namespace cocoon {
namespace {

// Positive if normals point away from what is enclosed.
double volume_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6;
  }
  return sum;
}

// 1 = outside, as after the peel, of an octahedron without its first cells.
IdVector<CellId, std::uint8_t> reached_but(const Octahedron& o, std::size_t taken) {
  IdVector<CellId, std::uint8_t> reached(o.triangulation.num_cells(), 1);
  for (const CellId c : o.triangulation.finite_cells()) reached[c] = c.index() < taken ? 1 : 0;
  return reached;
}

TEST(SurfaceMesh, OfABodyFacesAwayFromIt) {
  const Octahedron o;
  const SurfaceMesh whole = surface_between(o.triangulation, reached_but(o, 0));
  EXPECT_EQ(whole.mesh.triangles.size(), 8U);
  EXPECT_EQ(whole.mesh.points.size(), 6U);  // not the center
  EXPECT_NEAR(volume_of(whole.mesh), 4.0 / 3, 1e-12);
  const SurfaceMesh notched = surface_between(o.triangulation, reached_but(o, 1));
  EXPECT_EQ(notched.mesh.triangles.size(), 8U - 1 + 3);
  EXPECT_EQ(notched.mesh.points.size(), 7U);
  EXPECT_NEAR(volume_of(notched.mesh), 7.0 / 6, 1e-12);
  EXPECT_TRUE(surface_between(o.triangulation, reached_but(o, 8)).mesh.triangles.empty());
}

TEST(SurfaceMesh, VerticesComeInTheOrderOfTheInput) {
  const Octahedron o;
  const SurfaceMesh surface = surface_between(o.triangulation, reached_but(o, 1));
  EXPECT_TRUE(std::is_sorted(surface.point_of_vertex.begin(), surface.point_of_vertex.end()));
  for (const VertexId v : surface.mesh.points.ids()) {
    const VertexId there = surface.triangulation_vertex[v];
    EXPECT_EQ(surface.mesh.points[v], o.triangulation.point(there));
    EXPECT_EQ(surface.point_of_vertex[v], o.triangulation.point_of_vertex(there));
  }
}

TEST(SurfaceMesh, OfHalvesFacesThoseWhoSeeThem) {
  const Octahedron o;
  const LinkedFacets hull =
      link_facets(o.triangulation, o.facets([&](FacetId f) { return o.on_hull(f); }));
  std::vector<FacetId> from_outside;
  std::vector<FacetId> from_inside;
  for (std::size_t t = 0; t < hull.size(); ++t) {
    const bool is_inner = !o.triangulation.is_infinite(cell_of(hull.facets[t]));
    from_inside.push_back(is_inner ? hull.facets[t] : hull.mirrors[t]);
    from_outside.push_back(is_inner ? hull.mirrors[t] : hull.facets[t]);
  }
  const SurfaceMesh outward = surface_of(o.triangulation, from_outside);
  EXPECT_EQ(outward.mesh, surface_between(o.triangulation, reached_but(o, 0)).mesh);
  EXPECT_EQ(surface_of(o.triangulation, hull, from_outside).mesh, outward.mesh);
  const SurfaceMesh inward = surface_of(o.triangulation, from_inside);
  EXPECT_NEAR(volume_of(inward.mesh), -4.0 / 3, 1e-12);
  EXPECT_EQ(surface_of(o.triangulation, hull, from_inside).mesh, inward.mesh);
}

}  // namespace
}  // namespace cocoon
