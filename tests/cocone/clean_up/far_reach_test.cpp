#include "cocone/clean_up/far_reach.h"

#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"

namespace cocoon {
namespace {

// Two faces of a plate, `thickness` apart, with samples 1 apart, and one sample `depth` beneath the
// middle of a triangle of the upper one. Cells are IN, and labeled.
struct Plate {
  explicit Plate(double thickness, double depth, double near_surface = 0.5) {
    std::vector<Point> points;
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 8; ++k) {
        const double x = i + 0.01 * k;
        points.push_back({x, static_cast<double>(k), 0});
        points.push_back({x, static_cast<double>(k), thickness});
      }
    }
    points.push_back({3.3, 3.4, thickness - depth});
    t = delaunay(points).triangulation;
    v = t.vertex_of_point()[PointId(points.size() - 1)];
    marks.labels = IdVector<CellId, CellLabel>(t.num_cells(), CellLabel::in);
    out = IdVector<CellId, std::uint8_t>(t.num_cells(), 0);
    for (const CellId c : t.infinite_cells()) out[c] = 1;
    options.near_surface = near_surface;
  }
  Triangulation t;
  VertexId v;
  CellMarks marks;
  CleanUpOptions options;
  IdVector<CellId, std::uint8_t> out;
};

// The spacing of the sample is some 0.6.
bool is_near_surface(Plate plate) {
  StarCache stars(plate.t);
  SpacingCache spacings(plate.t, stars);
  FarReach reach(plate.t, stars, spacings, plate.marks, plate.options, plate.out);
  return reach.is_near_surface(plate.v);
}

TEST(FarReach, NearTheSurfaceIsHalfASpacing) {
  EXPECT_TRUE(is_near_surface(Plate(8, 0.05)));
  EXPECT_TRUE(is_near_surface(Plate(8, 0.2)));
  EXPECT_FALSE(is_near_surface(Plate(8, 0.9)));
  EXPECT_TRUE(is_near_surface(Plate(8, 0.9, 3)));
  EXPECT_FALSE(is_near_surface(Plate(8, 0.05, 0)));
}

// Facets of the surface that are long, as over a gap, tell nothing.
TEST(FarReach, LongFacetsAreNotNear) {
  Plate plate(8, 0.2);
  plate.options.stretch_ratio = 0.5;
  EXPECT_FALSE(is_near_surface(plate));
}

TEST(FarReach, CellsReachFarToTheOtherFace) {
  Plate plate(8, 0.2);
  StarCache stars(plate.t);
  SpacingCache spacings(plate.t, stars);
  FarReach reach(plate.t, stars, spacings, plate.marks, plate.options, plate.out);
  std::size_t far = 0;
  std::size_t near = 0;
  for (const CellId c : stars.star(plate.v)) {
    if (plate.t.is_infinite(c)) continue;
    bool is_across = false;
    for (const VertexId w : plate.t.cell(c).vertices) is_across |= plate.t.point(w).z == 0;
    EXPECT_EQ(reach.reaches_far(c, plate.v), is_across);
    (is_across ? far : near) += 1;
    plate.marks.labels[c] = CellLabel::unmarked;
    EXPECT_FALSE(reach.reaches_far(c, plate.v));
  }
  EXPECT_GT(far, 0U);
  EXPECT_GT(near, 0U);
}

}  // namespace
}  // namespace cocoon
