#include "cocone/solid/labels_of_solid.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "delaunay/delaunay.h"
#include "geom/mesh/dense_samples.h"
#include "geom/mesh_check.h"
#include "geom/surface_distance.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// [0, 4] x [0, 4] x [0, height].
TriangleMesh plate(double height) { return gallery::box(4, 4, height); }

std::vector<Point> samples_of(const TriangleMesh& mesh, double spacing) {
  std::vector<Point> points = mesh.points.raw();
  const std::vector<Point> added = dense_samples(mesh, {.spacing = spacing});
  points.insert(points.end(), added.begin(), added.end());
  return points;
}

Point centroid(const Triangulation& triangulation, CellId c) {
  Point sum;
  for (int i = 0; i < 4; ++i) sum = sum + triangulation.point(triangulation.vertex(c, i));
  return 0.25 * sum;
}

// Of two plates, one above the other: cells between them are outside.
TEST(LabelsOfSolid, TellTheSideAwayFromTheSurface) {
  const TriangleMesh solid = gallery::join(plate(1), gallery::translated(plate(1), {0, 0, 3}));
  const Triangulation triangulation = delaunay(samples_of(solid, 0.5)).triangulation;
  const KnownLabels known = labels_of_solid(triangulation, solid);
  std::size_t in = 0;
  std::size_t out = 0;
  for (const CellId c : triangulation.cells()) {
    if (triangulation.is_infinite(c)) {
      EXPECT_EQ(known.labels[c], CellLabel::unmarked);
      continue;
    }
    if (known.labels[c] == CellLabel::unmarked) continue;
    const double z = centroid(triangulation, c).z;
    const bool inside = z < 1 || z > 3;
    EXPECT_EQ(known.labels[c], inside ? CellLabel::in : CellLabel::out) << z;
    ++(inside ? in : out);
  }
  EXPECT_GT(in, 100U);
  EXPECT_GT(out, 100U);
  EXPECT_EQ(known.cells, in + out);

  // Whichever way the mesh is turned.
  EXPECT_EQ(labels_of_solid(triangulation, gallery::flipped(solid)).labels, known.labels);
  // The deeper they are to be, the fewer.
  const std::size_t deep = labels_of_solid(triangulation, solid, {.min_depth = 0.2}).cells;
  EXPECT_GT(deep, 0U);
  EXPECT_LT(deep, known.cells);
  EXPECT_EQ(labels_of_solid(triangulation, solid, {.min_depth = 1}).cells, 0U);
}

// Cells of which the same is known are left alone without a look at how deep they are: so are those
// of which the same would be told, and slivers.
TEST(LabelsOfSolid, AddedToWhatIsKnownAreForgottenWhereTheTwoDisagree) {
  const TriangleMesh solid = plate(1);
  const Triangulation triangulation = delaunay(samples_of(solid, 0.5)).triangulation;
  constexpr std::array<CellLabel, 3> labels = {CellLabel::unmarked, CellLabel::in, CellLabel::out};
  for (const CellPlaces places : {CellPlaces::centroid, CellPlaces::centroid_and_edges}) {
    const LabelsOfSolidOptions options = {places, 0.05};
    const KnownLabels told = labels_of_solid(triangulation, solid, options);
    KnownLabels known;
    known.labels = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
    std::vector<CellId> cells;
    for (const CellId c : triangulation.finite_cells()) {
      known.labels[c] = labels[c.index() % 3];
      if (known.labels[c] != CellLabel::unmarked) ++known.cells;
      if (c.index() % 4 != 0) cells.push_back(c);
    }
    const IdVector<CellId, CellLabel> before = known.labels;
    add_labels_of_solid(triangulation, solid, cells, known, options);
    std::size_t count = 0;
    for (const CellId c : triangulation.finite_cells()) {
      CellLabel expected = before[c];
      if (c.index() % 4 != 0 && told.labels[c] != CellLabel::unmarked &&
          told.labels[c] != before[c]) {
        expected = before[c] == CellLabel::unmarked ? told.labels[c] : CellLabel::unmarked;
      }
      EXPECT_EQ(known.labels[c], expected) << c.value;
      count += known.labels[c] == CellLabel::unmarked ? 0U : 1U;
    }
    EXPECT_EQ(known.cells, count);
  }
}

TEST(LabelsOfSolid, OfAnOpenMeshNothingIsKnown) {
  TriangleMesh open = plate(1);
  const Triangulation triangulation = delaunay(samples_of(open, 0.5)).triangulation;
  open.triangles.resize(open.triangles.size() - 1);
  const KnownLabels known = labels_of_solid(triangulation, open);
  EXPECT_TRUE(known.labels.empty());
  EXPECT_EQ(known.cells, 0U);
}

// Across a plate of a fifth of the spacing the samples alone do not tell in from out everywhere.
TEST(LabelsOfSolid, KeepThinWallsWhole) {
  const TriangleMesh solid = plate(0.05);
  const std::vector<Point> points = samples_of(solid, 0.25);
  const ReconstructResult alone = reconstruct_tight(points);
  const KnownLabelsSource sides = labels_told_by(solid, points);
  const ReconstructResult told = reconstruct_tight_with_labels(points, sides);
  const auto rms = [&](const ReconstructResult& result) {
    return surface_distance(result.mesh, solid, {.samples = 20000}).rms;
  };
  EXPECT_EQ(mesh_check(told.mesh).genus, 0U);
  EXPECT_EQ(told.unused_points, 0U);
  EXPECT_LT(rms(told), 0.001);
  EXPECT_GT(rms(alone), 4 * rms(told));

  ReconstructOptions paper;
  paper.mode = Mode::paper;
  EXPECT_EQ(reconstruct_tight_with_labels(points, sides, paper).mesh.triangles,
            reconstruct_tight(points, paper).mesh.triangles);
}

// Coordinates of extreme size are worked on at another scale.
TEST(LabelsOfSolid, AreToldAtTheScaleOfTheTriangulation) {
  const TriangleMesh solid = plate(0.05);
  const std::vector<Point> points = samples_of(solid, 0.25);
  const TriangleMesh tiny = gallery::scaled(solid, 0x1p-150);
  std::vector<Point> tiny_points = points;
  for (Point& p : tiny_points) p = 0x1p-150 * p;
  EXPECT_EQ(
      reconstruct_tight_with_labels(tiny_points, labels_told_by(tiny, tiny_points)).mesh.triangles,
      reconstruct_tight_with_labels(points, labels_told_by(solid, points)).mesh.triangles);
}

// A hollow box: what is known to be outside is not lost to the cavity's wall being told already.
TEST(LabelsOfSolid, LetCavitiesBeKept) {
  const TriangleMesh solid = gallery::join(
      gallery::cube(4), gallery::flipped(gallery::translated(gallery::cube(2), {1, 1, 1})));
  const std::vector<Point> points = samples_of(solid, 0.2);
  const KnownLabelsSource sides = labels_told_by(solid, points);
  const ReconstructResult filled = reconstruct_tight_with_labels(points, sides);
  EXPECT_GT(filled.unused_points, 500U);
  EXPECT_EQ(mesh_check(filled.mesh).components, 1U);
  const ReconstructResult hollow =
      reconstruct_tight_with_labels(points, sides, {.keep_cavities = true});
  EXPECT_EQ(hollow.counters.cavities.cavities, 1U);
  EXPECT_EQ(hollow.unused_points, 0U);
  EXPECT_EQ(mesh_check(hollow.mesh).components, 2U);
  EXPECT_LT(surface_distance(hollow.mesh, solid, {.samples = 20000}).rms, 0.01);
}

// A round hollow in a box, with walls of a third of the spacing where it is nearest to the faces:
// what touches there is repaired with the hollow open.
TEST(LabelsOfSolid, LetThinWallsOfHollowsBeWhole) {
  const TriangleMesh ball =
      gallery::translated(gallery::scaled(gallery::sphere(2), 1.9), {2, 2, 2});
  const TriangleMesh solid = gallery::join(gallery::cube(4), gallery::flipped(ball));
  const std::vector<Point> points = samples_of(solid, 0.3);
  const KnownLabelsSource sides = labels_told_by(solid, points, labels_of_crossing_cells);
  const ReconstructResult hollow =
      reconstruct_tight_with_labels(points, sides, {.keep_cavities = true});
  const MeshReport report = mesh_check(hollow.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(report.euler, 4);
  EXPECT_EQ(hollow.counters.cavities.cavities, 1U);
  EXPECT_LT(surface_distance(hollow.mesh, solid, {.samples = 20000}).rms, 0.03);
}

}  // namespace
}  // namespace cocoon
