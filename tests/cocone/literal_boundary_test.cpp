#include "cocone/literal_boundary.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Two squares side by side, each cut by a diagonal; the edge between them is a chord if all of
// their corners are boundary samples.
TEST(LiteralBoundary, CountsChordsAndMissedEdges) {
  const TriangleMesh mesh = gallery::open_patch(1, 2);
  const HalfedgeRings rings = link_halfedges(mesh);
  IdVector<VertexId, std::uint8_t> all(mesh.points.size(), 1);
  const LiteralBoundary literal = literal_boundary(mesh, rings, all);
  EXPECT_EQ(literal.edges, 9U);
  EXPECT_EQ(literal.chords, 3U);  // two diagonals and the edge in the middle
  EXPECT_EQ(literal.missed_edges, 0U);

  all[VertexId(0)] = 0;  // a corner: two edges of the rim end there
  EXPECT_EQ(literal_boundary(mesh, rings, all).missed_edges, 2U);
}

// An edge with three triangles is no rim either.
TEST(LiteralBoundary, AnEdgeWithThreeTrianglesIsAChord) {
  const TriangleMesh mesh = gallery::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const IdVector<VertexId, std::uint8_t> all(5, 1);
  const LiteralBoundary literal = literal_boundary(mesh, link_halfedges(mesh), all);
  EXPECT_EQ(literal.edges, 7U);
  EXPECT_EQ(literal.chords, 1U);
}

// On a clean patch the two definitions differ by few edges.
TEST(LiteralBoundary, AgreesOnACleanPatchButForAFewEdges) {
  const ReconstructResult open =
      reconstruct_cocone(shapes::dome_patch(30, 0.3, 4), open_cloud_defaults());
  const LiteralBoundary literal =
      literal_boundary(open.mesh, link_halfedges(open.mesh), open.boundary_sample);
  EXPECT_GT(literal.edges, 60U);
  EXPECT_LE(literal.chords, literal.edges / 10);
  EXPECT_LE(literal.missed_edges, literal.edges / 10);
}

TEST(LiteralBoundary, RefusesPartsOfAnotherSurface) {
  const TriangleMesh mesh = gallery::open_patch(2, 2);
  const HalfedgeRings rings = link_halfedges(mesh);
  EXPECT_THROW(literal_boundary(mesh, rings, IdVector<VertexId, std::uint8_t>(3, 1)), InputError);
  EXPECT_THROW(literal_boundary(mesh, {}, IdVector<VertexId, std::uint8_t>(9, 1)), InputError);
}

}  // namespace
}  // namespace cocoon
