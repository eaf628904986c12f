// Which cells a mesh of another program leaves to its inside and outside (known_labels.h).
#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <utility>
#include <vector>

#include "cocone/known_labels.h"
#include "cocone/reconstruct.h"
#include "delaunay/circulate.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/known_triangles.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// The surface of a cube, of unit squares, each with the diagonal from its smallest corner. The
// facets have the other one: ties of their corners are broken by coordinates.
std::vector<KnownTriangle> cube_of_squares(int size, std::vector<Point>& points) {
  std::map<std::array<int, 3>, PointId> ids;
  std::vector<KnownTriangle> triangles;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int level : {0, size}) {
      for (int i = 0; i < size * size; ++i) {
        const auto corner = [&](int u, int v) {
          std::array<int, 3> p{};
          p[axis] = level;
          p[(axis + 1) % 3] = i % size + u;
          p[(axis + 2) % 3] = i / size + v;
          const auto [at, is_new] = ids.try_emplace(p, PointId(points.size()));
          if (is_new) points.push_back({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]});
          return at->second;
        };
        std::array<KnownTriangle, 2> halves = {
            KnownTriangle{corner(0, 0), corner(1, 0), corner(1, 1)},
            KnownTriangle{corner(1, 1), corner(0, 1), corner(0, 0)}};
        for (KnownTriangle& t : halves) {
          if (level == 0) std::swap(t[0], t[1]);
          triangles.push_back(t);
        }
      }
    }
  }
  return triangles;
}

TEST(UndisturbedCells, AGridWithOtherDiagonalsIsNoMeshOfOurs) {
  std::vector<Point> points;
  const std::vector<KnownTriangle> squares = cube_of_squares(6, points);
  const Triangulation triangulation = delaunay(points).triangulation;
  const auto undisturbed = [](const Triangulation& t, const std::vector<KnownTriangle>& triangles) {
    const KnownLabels known = known_labels(t, triangles, FacetSet(t.num_cells()));
    for (const CellId c : known.undisturbed) EXPECT_EQ(known.labels[c], CellLabel::unmarked);
    return known.undisturbed;
  };
  EXPECT_TRUE(undisturbed(triangulation, triangles_of(reconstruct_tight(points))).empty());
  EXPECT_FALSE(undisturbed(triangulation, squares).empty());

  // A new point reaches across the cube. What is around others is kept, up to the cells between
  // them and the neighbors of the new one.
  points.push_back({3, 3, 5.5});
  const Triangulation grown = delaunay(points).triangulation;
  const VertexId added = grown.vertex_of_point()[PointId(points.size() - 1)];
  VertexSet beside_added(grown.num_vertices(), 0);
  for (const CellId c : grown.finite_cells()) {
    if (!has_vertex(grown.cell(c), added)) continue;
    for (const VertexId v : grown.cell(c).vertices) beside_added[v] = 1;
  }
  std::size_t beside = 0;
  for (const CellId c : undisturbed(grown, squares)) {
    const auto& corners = grown.cell(c).vertices;
    const auto count = std::count_if(corners.begin(), corners.end(),
                                     [&](VertexId v) { return beside_added[v] != 0; });
    EXPECT_LT(count, 4);
    beside += count > 0 ? 1U : 0U;
  }
  EXPECT_GT(beside, 0U);
}

// Beside such a mesh, in noise, vertices disagree: then the marking is done again without it. That
// nothing is likely makes no difference.
TEST(UndisturbedCells, TheMarkingIsDoneAgainWhereVerticesDisagree) {
  std::vector<Point> points;
  const std::vector<KnownTriangle> squares = cube_of_squares(6, points);
  for (const Point& p : shapes::noisy_sphere(3000, 0.01, 9)) {
    points.push_back(4 * p + Point{20, 0, 0});
  }
  const auto result = [&](bool has_likely) {
    const KnownLabelsSource source = [&](const Triangulation& triangulation,
                                         const FacetSet& surface, const Execution& execution) {
      KnownLabels known = known_labels(triangulation, squares, surface, execution);
      EXPECT_FALSE(known.undisturbed.empty());
      if (has_likely) {
        known.likely = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
      }
      return known;
    };
    return reconstruct_tight_with_labels(points, source);
  };
  const ReconstructResult nothing_likely = result(false);
  EXPECT_GT(nothing_likely.counters.marking_conflicts, 0U);
  EXPECT_GT(nothing_likely.counters.good_vertices, 1500U);
  EXPECT_EQ(nothing_likely.mesh, result(true).mesh);
}

}  // namespace
}  // namespace cocoon
