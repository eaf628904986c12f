#include "update/regions/grow_regions.h"

#include <gtest/gtest.h>

#include "geom/random/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// The same mesh with a triangle apart: then regions are grown one by one.
TriangleMesh with_one_apart(TriangleMesh mesh) {
  const VertexId first(mesh.points.size());
  for (const Point& p : {Point{9, 9, 9}, Point{9, 9, 8}, Point{9, 8, 9}}) mesh.points.push_back(p);
  mesh.triangles.push_back({first, VertexId(first.value + 1), VertexId(first.value + 2)});
  return mesh;
}

// Facets that cross one of the planes, and some others.
TriangleSet random_border(const TriangleMesh& mesh, std::size_t planes, Random& random) {
  TriangleSet border(mesh.triangles.size(), 0);
  for (std::size_t k = 0; k < planes; ++k) {
    const Vec3 normal = random.on_unit_sphere();
    const double offset = 0.9 * random.uniform();
    for (const TriangleId t : mesh.triangles.ids()) {
      int above = 0;
      for (const VertexId v : mesh.triangles[t]) above += dot(mesh.points[v], normal) > offset;
      if (above == 1 || above == 2) border[t] = 1;
    }
  }
  for (std::size_t k = 0; k < 5; ++k) border[TriangleId(random.below(border.size()))] = 1;
  return border;
}

TEST(GrowRegions, InStepAsOneByOne) {
  Random random(1);
  const TriangleMesh mesh = gallery::sphere(4);
  const ModelIndex connected(mesh);
  ASSERT_TRUE(connected.is_connected());
  const TriangleMesh more = with_one_apart(mesh);
  const ModelIndex apart(more);
  ASSERT_FALSE(apart.is_connected());
  std::size_t most = 0;
  for (std::size_t planes = 0; planes < 9; ++planes) {
    TriangleSet border = random_border(mesh, planes, random);
    const Regions in_step = grow_regions(connected, border);
    border.push_back(0);
    Regions one_by_one = grow_regions(apart, border);
    ASSERT_EQ(one_by_one.regions.size(), in_step.regions.size() + 1);
    for (const RegionId r : in_step.regions.ids()) {
      EXPECT_EQ(in_step.regions[r].first, one_by_one.regions[r].first);
      EXPECT_EQ(in_step.regions[r].facets, one_by_one.regions[r].facets);
    }
    for (const TriangleId t : mesh.triangles.ids()) {
      EXPECT_EQ(in_step.region_of_facet[t], one_by_one.region_of_facet[t]);
    }
    most = std::max(most, in_step.regions.size());
  }
  EXPECT_GT(most, 9U);
}

TEST(GrowRegions, WithoutABorderOrWithNothingElse) {
  const TriangleMesh mesh = gallery::sphere(1);
  const ModelIndex model(mesh);
  const Regions one = grow_regions(model, TriangleSet(mesh.triangles.size(), 0));
  ASSERT_EQ(one.regions.size(), 1U);
  EXPECT_EQ(one.regions[RegionId(0)].facets, mesh.triangles.size());
  EXPECT_TRUE(grow_regions(model, TriangleSet(mesh.triangles.size(), 1)).regions.empty());
}

}  // namespace
}  // namespace cocoon
