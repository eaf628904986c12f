#include "cocone/marking/likely_labels.h"

#include <gtest/gtest.h>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using Labels = IdVector<CellId, CellLabel>;

Labels labels(std::initializer_list<CellLabel> list) {
  Labels result;
  for (const CellLabel label : list) result.push_back(label);
  return result;
}

constexpr CellLabel none = CellLabel::unmarked;
constexpr CellLabel in = CellLabel::in;
constexpr CellLabel out = CellLabel::out;

TEST(LikelyLabels, AreContradictedByCellsOnTheOtherSide) {
  const Labels likely = labels({none, in, out, in, out, none});
  IdVector<CellId, std::uint8_t> reached(6, 0);
  reached[CellId(0)] = reached[CellId(1)] = reached[CellId(4)] = 1;
  EXPECT_EQ(count_labels(likely), 4U);
  EXPECT_EQ(count_contradicted(likely, reached), 2U);  // the first IN, the first OUT
  EXPECT_EQ(count_contradicted(labels({}), {}), 0U);
  EXPECT_THROW(count_contradicted(labels({in}), reached), InputError);
}

TEST(LikelyLabels, YieldToKnownOnes) {
  KnownLabels known;
  known.likely = labels({none, in, out, in});
  EXPECT_EQ(with_likely(known), known.likely);
  known.labels = labels({in, out, none, none});
  EXPECT_EQ(with_likely(known), labels({in, out, out, in}));
}

SurfaceRoughness roughness(TriangleMesh mesh, std::size_t unused = 0) {
  SurfaceMesh surface;
  surface.mesh = std::move(mesh);
  return surface_roughness(surface, surface.mesh.points.size() + unused);
}

void expect_roughness(const TriangleMesh& mesh, std::size_t parts, std::ptrdiff_t twice_handles) {
  const SurfaceRoughness found = roughness(mesh);
  EXPECT_EQ(found.parts, parts);
  EXPECT_EQ(found.twice_handles, twice_handles);
  EXPECT_EQ(found.unused_vertices, 0U);
}

TEST(SurfaceRoughness, CountsPartsAndTwiceTheHandles) {
  const TriangleMesh ball = reconstruct_tight(shapes::sphere(300, 1)).mesh;
  const TriangleMesh ring = reconstruct_tight(shapes::random_torus(1500, 0.4, 1)).mesh;
  expect_roughness(ball, 1, 0);
  expect_roughness(ring, 1, 2);
  expect_roughness(gallery::both(ball, ring), 2, 2);
  EXPECT_EQ(roughness(ball, 7).unused_vertices, 7U);
}

TEST(SurfaceRoughness, CountsWhereTheSurfaceTouchesItself) {
  expect_roughness(gallery::two_tetrahedra_sharing_an_edge(), 2, 2);
  expect_roughness(gallery::two_tetrahedra_sharing_a_vertex(), 2, 1);
}

TEST(SurfaceRoughness, IsComparedInEachNumber) {
  const SurfaceRoughness one{2, 4, 5};
  const auto is_at_most = [&](const SurfaceRoughness& other) { return one.is_at_most(other, 3); };
  EXPECT_TRUE(is_at_most({2, 4, 5}));
  EXPECT_TRUE(is_at_most({3, 6, 6}));
  EXPECT_FALSE(is_at_most({1, 9, 9}));
  EXPECT_FALSE(is_at_most({9, 2, 9}));
  EXPECT_FALSE(is_at_most({2, 4, 4}));
  EXPECT_FALSE(is_at_most({2, 5, 4}));
}

// A few unused vertices are worth a part less, but not a body, nor all of the surface.
TEST(SurfaceRoughness, APartLessIsWorthSomeVertices) {
  const SurfaceRoughness two{2, 0, 5};
  EXPECT_TRUE((SurfaceRoughness{1, 0, 8}).is_at_most(two, 3));
  EXPECT_FALSE((SurfaceRoughness{1, 0, 9}).is_at_most(two, 3));
  EXPECT_FALSE((SurfaceRoughness{0, 0, 5}).is_at_most(two, 3));
  EXPECT_TRUE((SurfaceRoughness{0, 0, 5}).is_at_most({0, 0, 5}, 3));
}

}  // namespace
}  // namespace cocoon
