// Which cells a foreign mesh leaves to its inside and outside (known_labels.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <utility>
#include <vector>

#include "cocone/known_labels.h"
#include "cocone/reconstruct.h"
#include "cocone/solid/labels_of_solid.h"
#include "delaunay/circulate.h"
#include "delaunay/delaunay.h"
#include "geom/signed_distance.h"
#include "tests/cocone/known_triangles.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// The surface of a body of unit cubes: of unit squares, each with the diagonal from its smallest
// corner. The facets have the other one: ties of their corners are broken by coordinates.
struct Squares {
  std::vector<Point> points;
  std::vector<KnownTriangle> triangles;
};

using Place = std::array<int, 3>;

Squares squares_around(int size, bool (*is_filled)(const Place&)) {
  Squares body;
  std::map<Place, PointId> ids;
  const auto id_of = [&](const Place& p) {
    const auto [at, is_new] = ids.try_emplace(p, PointId(body.points.size()));
    if (is_new) body.points.push_back({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]});
    return at->second;
  };
  const auto add_face = [&](const Place& cube, std::size_t axis, bool is_upper) {
    const auto corner = [&](int u, int v) {
      Place p = cube;
      p[axis] += is_upper ? 1 : 0;
      p[(axis + 1) % 3] += u;
      p[(axis + 2) % 3] += v;
      return id_of(p);
    };
    std::array<KnownTriangle, 2> halves = {KnownTriangle{corner(0, 0), corner(1, 0), corner(1, 1)},
                                           KnownTriangle{corner(1, 1), corner(0, 1), corner(0, 0)}};
    for (KnownTriangle& t : halves) {
      if (!is_upper) std::swap(t[0], t[1]);
      body.triangles.push_back(t);
    }
  };
  for (int i = 0; i < size * size * size; ++i) {
    const Place cube = {i % size, i / size % size, i / size / size};
    for (std::size_t axis = 0; axis < 3 && is_filled(cube); ++axis) {
      for (const bool is_upper : {false, true}) {
        Place other = cube;
        other[axis] += is_upper ? 1 : -1;
        if (!is_filled(other)) add_face(cube, axis, is_upper);
      }
    }
  }
  return body;
}

Squares cube_of_squares() {
  return squares_around(6, [](const Place& p) {
    return std::all_of(p.begin(), p.end(), [](int x) { return x >= 0 && x < 6; });
  });
}

TEST(UndisturbedCells, AGridWithOtherDiagonalsIsNoMeshOfOurs) {
  auto [points, squares] = cube_of_squares();
  const Triangulation triangulation = delaunay(points).triangulation;
  const auto undisturbed = [](const Triangulation& t, const std::vector<KnownTriangle>& triangles) {
    return known_labels(t, triangles, FacetSet(t.num_cells())).undisturbed;
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

// A step with a vertex on its upper face, close to the edge. The triangle of the wall at that edge
// is no facet, and cells in the air before it reach around the edge to that vertex, whose own
// triangles, all of them facets, have them inside.
TEST(UndisturbedCells, ATriangleThatIsNoFacetMayCutThroughACell) {
  auto [points, triangles] = squares_around(8, [](const Place& p) {
    const bool is_in_box = std::all_of(p.begin(), p.end(), [](int x) { return x >= 0 && x < 8; });
    return is_in_box && (p[2] < 3 || p[0] >= 3);
  });
  const std::vector<Point> square = {{3, 3, 8}, {4, 3, 8}, {4, 4, 8}, {3, 4, 8}};
  const auto is_of_square = [&](PointId p) {
    return std::find(square.begin(), square.end(), points[p.index()]) != square.end();
  };
  std::erase_if(triangles, [&](const KnownTriangle& t) {
    return std::all_of(t.begin(), t.end(), is_of_square);
  });
  const auto id_of = [&](const Point& p) {
    const auto at = std::find(points.begin(), points.end(), p);
    return PointId(static_cast<std::size_t>(at - points.begin()));
  };
  const PointId added(points.size());
  points.push_back({3.003, 3.5, 8});
  for (std::size_t i = 0; i < 4; ++i) {
    triangles.push_back({id_of(square[i]), id_of(square[(i + 1) % 4]), added});
  }
  TriangleMesh mesh;
  for (const Point& p : points) mesh.points.push_back(p);
  for (const auto& [a, b, c] : triangles) {
    mesh.triangles.push_back({VertexId(a.value), VertexId(b.value), VertexId(c.value)});
  }

  const Triangulation triangulation = delaunay(points).triangulation;
  const auto middle_of = [&](CellId c) {
    const auto& [p, q, r, s] = triangulation.cell(c).vertices;
    return 0.25 * (triangulation.point(p) + triangulation.point(q) + triangulation.point(r) +
                   triangulation.point(s));
  };
  std::vector<Point> middles;
  for (const CellId c : triangulation.finite_cells()) middles.push_back(middle_of(c));
  const std::vector<double> depths = signed_distances(mesh, middles);
  const auto wrong = [&](const KnownLabels& known) {
    std::size_t count = 0;
    for (const CellId c : triangulation.finite_cells()) {
      const double depth = depths[c.index()];
      const CellLabel right = depth > 0 ? CellLabel::out : CellLabel::in;
      const bool is_told = known.labels[c] != CellLabel::unmarked;
      count += std::abs(depth) > 0.3 && is_told && known.labels[c] != right ? 1U : 0U;
    }
    return count;
  };
  KnownLabels known = known_labels(triangulation, triangles, FacetSet(triangulation.num_cells()));
  EXPECT_GT(wrong(known), 0U);
  add_labels_of_solid(triangulation, mesh, known.undisturbed, known, labels_of_crossing_cells);
  EXPECT_EQ(wrong(known), 0U);
}

// Beside such a mesh, in noise, vertices disagree: then the marking is done again without it. That
// nothing is likely makes no difference.
TEST(UndisturbedCells, TheMarkingIsDoneAgainWhereVerticesDisagree) {
  auto [points, squares] = cube_of_squares();
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
