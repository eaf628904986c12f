#include "update/regions/kept_surface.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "cocone/reconstruct.h"
#include "delaunay/delaunay.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/mesh_gallery.h"
#include "tests/update/replaced_disk.h"

namespace cocoon {
namespace {

using testing::ReplacedDisk;

// A cube of 14 unit steps, its faces stirred.
std::vector<Point> rough_cube(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points = shapes::cube_grid(14);
  const auto stir = [&](double& x) {
    if (x > 0 && x < 14) x += 0.3 * (2 * random.uniform() - 1);
  };
  for (Point& p : points) {
    stir(p.x);
    stir(p.y);
    stir(p.z);
  }
  return points;
}

// Two cubes, each reconstructed by itself, in one mesh.
TriangleMesh cubes_side_by_side(double gap) {
  return gallery::join(reconstruct_tight(rough_cube(1)).mesh,
                       reconstruct_tight(shapes::moved(rough_cube(2), {14 + gap, 0.4, 0.3})).mesh);
}

TEST(KeptSurface, TrianglesOfKeptRegionsAreKnown) {
  const ReplacedDisk scene;
  const Replacement result = scene.replace();
  std::size_t far = 0;
  for (const Triangle& t : scene.model.triangles) {
    far += std::all_of(t.begin(), t.end(), [&](VertexId v) {
      return distance(scene.model.points[v], {10, 10, 0}) > 8;
    });
  }
  const ModelIndex index(scene.model);
  const std::vector<KnownTriangle> known =
      KeptSurface(index, scene.regions, scene.choice, result).triangles();
  EXPECT_GE(known.size(), far);
  for (const KnownTriangle& t : known) {
    for (const PointId p : t) {
      ASSERT_LT(p.index(), result.vertices.kept);
      EXPECT_GT(distance(result.points[p.index()], {10, 10, 0}), 6.3);
    }
    const Point& a = result.points[t[0].index()];
    const Vec3 normal = cross(result.points[t[1].index()] - a, result.points[t[2].index()] - a);
    EXPECT_GT(normal.z, 0);  // turned as in the model
  }
}

// By the definition.
TEST(KeptSurface, OtherTrianglesAreNotKnownEvenIfTheirCornersStay) {
  const ReplacedDisk scene;
  Replacement none_removed;
  for (const VertexId v : scene.model.points.ids()) {
    none_removed.point_of_vertex.push_back(PointId(v.value));
  }
  std::size_t expected = 0;
  for (const TriangleId t : scene.model.triangles.ids()) {
    const RegionId region = scene.regions.region_of_facet[t];
    expected += !region.is_none() && scene.choice.replaced[region] == 0 ? 1U : 0U;
  }
  const ModelIndex index(scene.model);
  const KeptSurface kept(index, scene.regions, scene.choice, none_removed);
  EXPECT_EQ(kept.triangles().size(), expected);
}

// Each kept point either has all its triangles, or is told to be torn.
TEST(KeptSurface, TellsWhereTrianglesAreMissing) {
  const ReplacedDisk scene;
  const Replacement result = scene.replace();
  const ModelIndex index(scene.model);
  const KeptSurface kept(index, scene.regions, scene.choice, result);
  const std::vector<KnownTriangle> known = kept.triangles();
  const std::vector<PointId> torn_list = kept.torn();
  const std::set<PointId> torn(torn_list.begin(), torn_list.end());
  const std::set<KnownTriangle> all(known.begin(), known.end());
  std::size_t whole = 0;
  for (const VertexId v : scene.model.points.ids()) {
    const PointId p = result.point_of_vertex[v];
    if (p.is_none()) continue;
    const std::vector<KnownTriangle> at = kept.at(std::vector{p});
    const auto has_p = [&](const KnownTriangle& t) { return std::ranges::count(t, p) == 1; };
    EXPECT_EQ(at.size(),
              static_cast<std::size_t>(std::count_if(known.begin(), known.end(), has_p)));
    EXPECT_TRUE(std::all_of(at.begin(), at.end(),
                            [&](const KnownTriangle& t) { return has_p(t) && all.contains(t); }));
    EXPECT_EQ(at.size() < index.triangles_at(v).size(), torn.contains(p)) << v.value;
    whole += torn.contains(p) ? 0U : 1U;
  }
  EXPECT_GT(torn.size(), 20U);
  EXPECT_GT(whole, 100U);
  // Of several points, some of them of the cloud, each triangle once.
  std::vector<PointId> everywhere;
  for (std::size_t p = 0; p < result.points.size(); ++p) everywhere.push_back(PointId(p));
  EXPECT_EQ(kept.at(everywhere), known);
}

// Where sheets are closer to each other than their vertices are, triangles of the model are no
// facets.
TEST(KeptSurface, WhatIsUndisturbedIsToldByTheModel) {
  const double gap = 0.3;
  const TriangleMesh model = cubes_side_by_side(gap);
  Regions regions;
  regions.region_of_facet =
      SparseVector<TriangleId, RegionId>(model.triangles.size(), RegionId(0U));
  RegionChoice choice;
  choice.replaced.resize(1);
  Replacement replacement;
  const Points points = model.points.span();
  replacement.points.assign(points.begin(), points.end());
  replacement.vertices.kept = points.size();
  for (const VertexId v : model.points.ids()) {
    replacement.point_of_vertex.push_back(PointId(v.value));
  }
  const ModelIndex index(model);
  const KeptSurface kept(index, regions, choice, replacement);
  const Triangulation triangulation = delaunay(points).triangulation;
  const KnownLabels known =
      kept.told().labels(triangulation, FacetSet(triangulation.num_cells()), {});
  std::size_t between = 0;
  for (const CellId c : triangulation.finite_cells()) {
    const auto& [v, w, x, y] = triangulation.cell(c).vertices;
    const Point middle = 0.25 * (triangulation.point(v) + triangulation.point(w) +
                                 triangulation.point(x) + triangulation.point(y));
    if (middle.x < 14.1 || middle.x > 13.9 + gap) continue;
    ++between;
    EXPECT_EQ(known.labels[c], CellLabel::out);
  }
  EXPECT_GT(between, 100U);
}

}  // namespace
}  // namespace cocoon
