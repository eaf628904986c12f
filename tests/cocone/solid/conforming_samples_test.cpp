#include "cocone/solid/conforming_samples.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "cocone/solid/cell_heights.h"
#include "cocone/solid/labels_of_solid.h"
#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "geom/mesh/dense_samples.h"
#include "geom/mesh_check.h"
#include "geom/search/closest_facet.h"
#include "geom/surface_distance.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Two plates of 4 by 4 by 1, a gap of a third of the spacing between them.
constexpr double spacing = 0.3;
TriangleMesh two_plates(double gap = 0.1) {
  return gallery::join(gallery::box(4, 4, 1),
                       gallery::translated(gallery::box(4, 4, 1), {0, 0, 1 + gap}));
}

std::vector<Point> samples_of(const TriangleMesh& mesh) {
  std::vector<Point> points = mesh.points.raw();
  const std::vector<Point> added = dense_samples(mesh, {.spacing = spacing});
  points.insert(points.end(), added.begin(), added.end());
  return points;
}

std::vector<Point> joined(std::vector<Point> points, const std::vector<Point>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

std::size_t crossing_cells(const TriangleMesh& solid, const std::vector<Point>& points) {
  const Triangulation triangulation = delaunay(points).triangulation;
  std::vector<CellId> cells;
  for (const CellId c : triangulation.finite_cells()) cells.push_back(c);
  const std::vector<CellHeights> heights =
      cell_heights(triangulation, cells, solid, CellPlaces::centroid_and_edges);
  return static_cast<std::size_t>(std::count_if(
      heights.begin(), heights.end(), [](const CellHeights& h) { return h.crosses(0.02); }));
}

TEST(ConformingSamples, LeaveNoCellThatCrossesTheMesh) {
  const TriangleMesh solid = two_plates();
  const std::vector<Point> samples = samples_of(solid);
  ASSERT_GT(crossing_cells(solid, samples), 20U);
  const ConformingSamples more = conforming_samples(solid, samples, {.spacing = spacing});
  const std::vector<Point> all = joined(samples, more.added);
  EXPECT_EQ(crossing_cells(solid, all), 0U);
  EXPECT_EQ(more.without_room, 0U);
  EXPECT_GT(more.rounds, 1U);
  EXPECT_LT(more.added.size(), samples.size());

  // All are on the mesh, and not close to each other.
  const ClosestFacetTree tree(solid);
  for (const Point& p : more.added) EXPECT_LT(tree.closest(p).squared_distance, 1e-24);
  for (std::size_t k = samples.size(); k < all.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) EXPECT_GE(distance(all[i], all[k]), spacing / 16);
  }
}

TEST(ConformingSamples, KeepBodiesApartThatSamplesJoin) {
  const TriangleMesh solid = two_plates();
  const auto surface_of = [&](const std::vector<Point>& points) {
    return reconstruct_tight_with_labels(points, labels_told_by(solid, points)).mesh;
  };
  const std::vector<Point> samples = samples_of(solid);
  EXPECT_NE(mesh_check(surface_of(samples)).components, 2U);
  const ConformingSamples more = conforming_samples(solid, samples, {.spacing = spacing});
  const TriangleMesh surface = surface_of(joined(samples, more.added));
  const MeshReport report = mesh_check(surface);
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(report.genus, 0U);
  EXPECT_LT(surface_distance(surface, solid, {.samples = 20000}).rms, 1e-3 * spacing);
}

// On the edges of the lower plate.
std::size_t on_edges(const std::vector<Point>& points) {
  const auto is_extreme = [](double x, double largest) { return x == 0 || x == largest; };
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const Point& p) {
    return (is_extreme(p.x, 4) ? 1 : 0) + (is_extreme(p.y, 4) ? 1 : 0) +
               (is_extreme(p.z, 1) ? 1 : 0) >=
           2;
  }));
}

// Along a gap of a tenth of the spacing. A cell at two edges crosses the mesh again as long as the
// edges are not cut.
TEST(ConformingSamples, CutSharpEdgesNearby) {
  const TriangleMesh solid = two_plates(0.03);
  const std::vector<Point> samples = samples_of(solid);
  const std::vector<Point> cut = conforming_samples(solid, samples, {.spacing = spacing}).added;
  const std::vector<Point> beside =
      conforming_samples(solid, samples, {.spacing = spacing, .snap = 0}).added;
  EXPECT_GT(on_edges(cut), 50U);
  EXPECT_EQ(on_edges(beside), 0U);
  EXPECT_LT(1.3 * static_cast<double>(cut.size()), static_cast<double>(beside.size()));
  EXPECT_LT(20 * crossing_cells(solid, joined(samples, cut)),
            crossing_cells(solid, joined(samples, beside)));
}

TEST(ConformingSamples, AreNoneWhereTheSpacingIsFine) {
  const TriangleMesh solid = gallery::box(4, 4, 4);
  const ConformingSamples more = conforming_samples(solid, samples_of(solid), {.spacing = spacing});
  EXPECT_TRUE(more.added.empty());
  EXPECT_EQ(more.rounds, 0U);
}

TEST(ConformingSamples, StopAtTheClosestDistanceAndTheLastRound) {
  const TriangleMesh solid = two_plates();
  const std::vector<Point> samples = samples_of(solid);
  const ConformingSamples far = conforming_samples(solid, samples, {.spacing = 1, .closest = 1});
  EXPECT_GT(far.without_room, 0U);
  const ConformingSamples one =
      conforming_samples(solid, samples, {.spacing = spacing, .max_rounds = 1});
  EXPECT_EQ(one.rounds, 1U);
  EXPECT_GT(crossing_cells(solid, joined(samples, one.added)), 0U);
}

// Not of the order of cells, which depends on threads, nor of the unit of length.
TEST(ConformingSamples, AreAFunctionOfMeshAndSamples) {
  const TriangleMesh solid = two_plates();
  const std::vector<Point> samples = samples_of(solid);
  const std::vector<Point> added =
      conforming_samples(solid, samples, {.spacing = spacing}, {.threads = 1}).added;
  ASSERT_FALSE(added.empty());
  for (int run = 0; run < 5; ++run) {
    EXPECT_EQ(conforming_samples(solid, samples, {.spacing = spacing}, {.threads = 3}).added,
              added);
  }
  for (const double factor : {0x1p-200, 0x1p200}) {
    const TriangleMesh other = gallery::scaled(solid, factor);
    std::vector<Point> points = samples;
    for (Point& p : points) p = factor * p;
    std::vector<Point> more =
        conforming_samples(other, points, {.spacing = factor * spacing}).added;
    for (Point& p : more) p = p / factor;
    EXPECT_EQ(more, added) << factor;
  }
}

TEST(ConformingSamples, NeedAClosedMeshAndPossibleOptions) {
  TriangleMesh open = two_plates();
  const std::vector<Point> samples = samples_of(open);
  EXPECT_THROW(conforming_samples(open, samples, {}), InputError);
  EXPECT_THROW(conforming_samples(open, samples, {.spacing = 1, .closest = -1}), InputError);
  EXPECT_THROW(conforming_samples(open, samples, {.spacing = 1, .min_depth = -1}), InputError);
  open.triangles.resize(open.triangles.size() - 1);
  EXPECT_TRUE(conforming_samples(open, samples, {.spacing = spacing}).added.empty());
}

}  // namespace
}  // namespace cocoon
