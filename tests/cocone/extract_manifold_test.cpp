#include "cocone/extract_manifold.h"

#include <gtest/gtest.h>

#include "cocone/facets/linked_facets.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// A finite facet between two cells without an infinite neighbor.
FacetId inner_facet(const Triangulation& t) {
  const auto is_inner = [&](CellId c) {
    for (int i = 0; i < 4; ++i) {
      if (t.is_infinite(c) || t.is_infinite(t.neighbor(c, i))) return false;
    }
    return true;
  };
  for (const CellId c : t.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      if (is_inner(c) && is_inner(t.neighbor(c, i))) return facet_id(c, i);
    }
  }
  return {};
}

// All seven facets of two flat tetrahedra, the only possible start is between them: no side of it
// is that of a sheet.
TEST(ExtractManifold, NoWalkBeginsInsideFlatTetrahedra) {
  const Triangulation t = delaunay(shapes::random_cube(100, 1)).triangulation;
  const FacetId between = inner_facet(t);
  ASSERT_FALSE(between.is_none());
  FacetSet candidates(t.num_cells());
  for (const CellId c : {cell_of(between), cell_of(t.mirror(between))}) {
    for (int i = 0; i < 4; ++i) candidates.insert(t, facet_id(c, i));
  }
  VertexSet umbrella(t.num_vertices(), 0);
  for (const VertexId v : t.facet_vertices(between)) umbrella[v] = 1;
  const ManifoldSurface surface = extract_manifold(t, link_facets(t, candidates), umbrella);
  EXPECT_EQ(surface.walks, 0U);
  EXPECT_EQ(surface.unwalked, 7U);
  EXPECT_EQ(surface.triangles.size(), 7U);
}

// From one flat tetrahedron the walk begins outside.
TEST(ExtractManifold, AWalkBeginsOutsideOfAFlatTetrahedron) {
  const Triangulation t = delaunay(shapes::random_cube(100, 1)).triangulation;
  const CellId flat = cell_of(inner_facet(t));
  FacetSet candidates(t.num_cells());
  for (int i = 0; i < 4; ++i) candidates.insert(t, facet_id(flat, i));
  const ManifoldSurface surface =
      extract_manifold(t, link_facets(t, candidates), VertexSet(t.num_vertices(), 1));
  EXPECT_EQ(surface.walks, 1U);
  ASSERT_EQ(surface.halves.size(), 4U);
  for (const FacetId half : surface.halves) EXPECT_NE(cell_of(half), flat);
}

}  // namespace
}  // namespace cocoon
