#include "geom/search/grid_cells.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

using PointList = IdVector<VertexId, Point>;

std::vector<VertexId> found_in(const GridCells& cells, const Box& box, const PointList& points) {
  std::vector<VertexId> found;
  cells.visit_in(box, points, [&](VertexId v) { found.push_back(v); });
  return found;
}

std::vector<VertexId> all_in(const Box& box, const PointList& points) {
  std::vector<VertexId> found;
  for (const VertexId v : points.ids()) {
    if (contains(box, points[v])) found.push_back(v);
  }
  return found;
}

// Some of them on the corners of others.
Box random_box(Random& random, const PointList& points) {
  Box box;
  for (int k = 0; k < 2; ++k) {
    box.include(random.below(2) == 0 && !points.empty()
                    ? points[VertexId(random.below(points.size()))]
                    : 3 * random.in_unit_cube() - Vec3{1, 1, 1});
  }
  return box;
}

TEST(GridCells, ByHand) {
  const PointList points(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}});
  const GridCells cells(points);
  EXPECT_EQ(found_in(cells, {{0.5, 0, 0}, {1, 1, 0.5}}, points),
            (std::vector{VertexId(1), VertexId(2)}));
  EXPECT_EQ(found_in(cells, {{1, 1, 1}, {2, 2, 2}}, points), std::vector{VertexId(3)});
  EXPECT_TRUE(found_in(cells, {{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}}, points).empty());
  EXPECT_TRUE(found_in(cells, Box(), points).empty());
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(
      found_in(cells, {{-infinity, -infinity, 0}, {infinity, infinity, infinity}}, points).size(),
      4U);
}

TEST(GridCells, FindWhatLiesInABoxWhateverWasEdited) {
  Random random(5);
  for (const double height : {1.0, 1e-12, 0.0}) {
    PointList points;
    for (int i = 0; i < 1000; ++i) {
      const Point p = random.in_unit_cube();
      points.push_back({p.x, p.y, height * p.z});
    }
    GridCells cells(points);
    for (int round = 0; round < 20; ++round) {
      for (int i = 0; i < 20; ++i) {
        const Box box = random_box(random, points);
        EXPECT_EQ(found_in(cells, box, points), all_in(box, points));
      }
      ListEdit<VertexId> edit;
      std::vector<Point> added;
      for (const VertexId v : points.ids()) {
        if (random.below(20) == 0) edit.removed.push_back(v);
      }
      const std::size_t count = 5 + random.below(70);
      const std::size_t size = points.size() - edit.removed.size() + count;
      for (std::size_t place = 0; place < size && added.size() < count; ++place) {
        if (size - place > count - added.size() && random.below(8) != 0) continue;
        edit.added.push_back(VertexId(place));
        added.push_back(3 * random.in_unit_cube() - Vec3{1, 1, 1});  // off the grid, too
      }
      edit_list(points, edit, added);
      cells.edit(edit, added);
      ASSERT_EQ(cells.size(), points.size());
    }
  }
}

}  // namespace
}  // namespace cocoon
