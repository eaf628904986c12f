#include "update/regions/seen_cells.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/point_queries.h"
#include "geom/errors.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// A cube full of points about 0.1 apart.
struct Scene {
  Triangulation triangulation = delaunay(gallery::uniform_cube(1000)).triangulation;
  KnownLabels known;

  void see(const std::vector<Sight>& sights, const SightOptions& options = {}) {
    add_seen_cells(triangulation, sights, options, known);
  }
  CellLabel at(const Point& p) const { return known.likely[locate(triangulation, p).cell]; }
  std::size_t count(CellLabel label) const {
    return static_cast<std::size_t>(std::count(known.likely.begin(), known.likely.end(), label));
  }
};

Sight along_x(double from, double to, bool is_air) {
  return {{from, 0.51, 0.52}, {to, 0.51, 0.52}, is_air, 0.1};
}

TEST(SeenCells, AreThoseOnTheLineFromACertainDistanceOn) {
  Scene scene;
  scene.see({along_x(0.1, 0.9, true)});
  for (double x = 0.2; x < 0.9; x += 0.025) {
    EXPECT_EQ(scene.at({x, 0.51, 0.52}), CellLabel::out) << x;
  }
  EXPECT_EQ(scene.at({0.5, 0.8, 0.2}), CellLabel::unmarked);
  EXPECT_EQ(scene.count(CellLabel::in), 0U);
  const std::size_t all = scene.count(CellLabel::out);
  EXPECT_GE(all, 7U);

  scene.see({along_x(0.1, 0.9, true)}, {.clearance = 5});
  EXPECT_LT(scene.count(CellLabel::out), all);
  EXPECT_EQ(scene.at({0.2, 0.51, 0.52}), CellLabel::unmarked);
}

TEST(SeenCells, AreInTheBodyWhereNoAirIs) {
  Scene scene;
  scene.see({along_x(0.1, 0.9, false)});
  EXPECT_EQ(scene.at({0.5, 0.51, 0.52}), CellLabel::in);
  EXPECT_EQ(scene.count(CellLabel::out), 0U);
}

TEST(SeenCells, AreNotThoseThatLinesTellBoth) {
  Scene scene;
  scene.see({along_x(0.1, 0.7, true), along_x(0.9, 0.3, false)});
  EXPECT_EQ(scene.at({0.25, 0.51, 0.52}), CellLabel::out);
  EXPECT_EQ(scene.at({0.5, 0.51, 0.52}), CellLabel::unmarked);
  EXPECT_EQ(scene.at({0.75, 0.51, 0.52}), CellLabel::in);
}

TEST(SeenCells, AreNotThoseThatAreKnown) {
  Scene scene;
  const CellId known = locate(scene.triangulation, {0.5, 0.51, 0.52}).cell;
  scene.known.labels =
      IdVector<CellId, CellLabel>(scene.triangulation.num_cells(), CellLabel::unmarked);
  scene.known.labels[known] = CellLabel::in;
  scene.see({along_x(0.1, 0.9, true)});
  EXPECT_EQ(scene.known.likely[known], CellLabel::unmarked);
  EXPECT_GT(scene.count(CellLabel::out), 5U);
}

TEST(SeenCells, AreNoneWithoutLinesOrSteps) {
  Scene scene;
  scene.see({});
  EXPECT_TRUE(scene.known.likely.empty());
  scene.see({along_x(0.1, 0.9, true)}, {.step = 0});
  EXPECT_TRUE(scene.known.likely.empty());
  EXPECT_THROW(scene.see({}, {.step = -1}), InputError);
  EXPECT_THROW(scene.see({}, {.clearance = std::numeric_limits<double>::quiet_NaN()}), InputError);
}

TEST(SeenCells, AreFoundByStepsOfAnyLength) {
  Scene scene;
  scene.see({along_x(0.1, 0.9, true)}, {.step = 1e-300});
  EXPECT_EQ(scene.at({0.5, 0.51, 0.52}), CellLabel::out);
  scene.see({along_x(0.1, 0.9, true)}, {.step = std::numeric_limits<double>::infinity()});
  EXPECT_LE(scene.count(CellLabel::out), 1U);
}

// Beyond the hull, and as short as the distance that is left out.
TEST(SeenCells, MayBeNone) {
  Scene scene;
  scene.see({{{2, 2, 2}, {3, 3, 3}, true, 0.1}, along_x(0.5, 0.55, true)});
  EXPECT_EQ(scene.count(CellLabel::unmarked), scene.known.likely.size());
}

}  // namespace
}  // namespace cocoon
