// What a change does to the boundary of a kept body is what two looks at the whole boundary tell.
#include "cocone/kept_body.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cocone/lent_delaunay.h"
#include "delaunay/delaunay.h"
#include "geom/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/long_tests.h"

namespace cocoon {
namespace {

using Corners = std::array<VertexId, 3>;
using CornerPoints = std::array<Point, 3>;

// By their corners, counterclockwise from the smallest one.
template <class Corner>
std::array<Corner, 3> smallest_corner_first(std::array<Corner, 3> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Counterclockwise seen from outside.
std::set<Corners> boundary_of(const Triangulation& triangulation,
                              const IdVector<CellId, std::uint8_t>& out) {
  std::set<Corners> boundary;
  for (const CellId c : triangulation.cells()) {
    for (int i = 0; i < 4; ++i) {
      if (out[c] != 0 || out[triangulation.neighbor(c, i)] == 0) continue;
      boundary.insert(smallest_corner_first(triangulation.facet_vertices(facet_id(c, i))));
    }
  }
  return boundary;
}

// The triangles at each vertex, all as points.
std::map<Point, std::set<CornerPoints>> by_point(const Triangulation& triangulation,
                                                 const std::set<Corners>& boundary) {
  std::map<Point, std::set<CornerPoints>> triangles;
  for (const auto& [a, b, c] : boundary) {
    const CornerPoints corners = smallest_corner_first<Point>(
        {triangulation.point(a), triangulation.point(b), triangulation.point(c)});
    for (const Point& p : corners) triangles[p].insert(corners);
  }
  return triangles;
}

// Ascending; infinity stands for the infinite vertex.
using CellCorners = std::array<Point, 4>;
template <class AnyTriangulation>
CellCorners corners_of_cell(const AnyTriangulation& triangulation, CellId c) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CellCorners corners;
  for (int i = 0; i < 4; ++i) {
    const VertexId v = triangulation.vertex(c, i);
    corners[static_cast<std::size_t>(i)] =
        v == infinite_vertex ? Point{infinity, infinity, infinity} : triangulation.point(v);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

// The samples of a sphere: each vertex is on the hull.
class ChangingBall {
 public:
  explicit ChangingBall(std::size_t count)
      : delaunay_(cocoon::delaunay(shapes::sphere(count, 3)).triangulation) {
    delaunay_.close_gaps();
  }

  // The cells that have been there since the last call of keep().
  const std::set<CellCorners>& old_cells() const { return old_cells_; }
  void keep() { old_cells_ = cells(); }

  // Some samples go and others come, near a random one, now and then in two steps.
  void change(Random& random, KeptBody& kept) {
    for (std::size_t steps = 1 + random.below(2); steps > 0; --steps) {
      const Point center = random.on_unit_sphere();
      std::vector<VertexId> removed;
      for (const VertexId v : id_range<VertexId>(delaunay_.num_vertex_slots())) {
        if (!delaunay_.contains(v) || distance(delaunay_.point(v), center) > 0.3) continue;
        if (random.below(2) == 0) removed.push_back(v);
      }
      std::vector<Point> inserted(random.below(20));
      for (Point& p : inserted) p = unit(center + 0.2 * random.on_unit_sphere());
      kept.update(delaunay_, delaunay_.replace(removed, inserted));
      const std::set<CellCorners> now = cells();
      std::erase_if(old_cells_, [&](const CellCorners& cell) { return !now.contains(cell); });
    }
    kept.renumber(delaunay_.close_gaps(), delaunay_);
  }

  template <class Visit>
  void lend(Visit visit) {
    IdVector<PointId, VertexId> vertex_of_point;
    for (std::size_t v = 0; v < delaunay_.num_vertices(); ++v) {
      vertex_of_point.push_back(VertexId(v));
    }
    const LentDelaunay lent(delaunay_, vertex_of_point);
    visit(*lent, delaunay_.cells_at_vertices());
  }

 private:
  std::set<CellCorners> cells() const {
    std::set<CellCorners> found;
    const TriangulationView view = delaunay_.view();
    for (const CellId c : view.cell_records().ids()) {
      if (!view.is_free(c)) found.insert(corners_of_cell(view, c));
    }
    return found;
  }

  DynamicDelaunay delaunay_;
  std::set<CellCorners> old_cells_;
};

// All finite cells, but for some with two facets on the hull: there the boundary takes the other
// two facets of the cell, so that an edge is flipped, if it does not have the new edge elsewhere.
IdVector<CellId, std::uint8_t> body_out(const Triangulation& triangulation, Random& random) {
  IdVector<CellId, std::uint8_t> out(triangulation.num_cells(), 0);
  for (const CellId c : triangulation.infinite_cells()) out[c] = 1;
  std::set<std::set<VertexId>> edges;
  for (const Corners& corners : boundary_of(triangulation, out)) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert({corners[k], corners[(k + 1) % 3]});
  }
  std::set<VertexId> used;
  for (const CellId c : triangulation.finite_cells()) {
    std::set<VertexId> new_edge;  // the vertices opposite to facets on the hull
    for (int i = 0; i < 4; ++i) {
      if (triangulation.is_infinite(triangulation.neighbor(c, i))) {
        new_edge.insert(triangulation.vertex(c, i));
      }
    }
    const auto& vertices = triangulation.cell(c).vertices;
    if (new_edge.size() != 2 || edges.contains(new_edge) || random.below(3) != 0 ||
        std::any_of(vertices.begin(), vertices.end(),
                    [&](VertexId v) { return used.contains(v); })) {
      continue;
    }
    used.insert(vertices.begin(), vertices.end());
    out[c] = 1;
  }
  return out;
}

CellMarks marks_of(const Triangulation& triangulation, IdVector<CellId, std::uint8_t> out) {
  CellMarks marks;
  marks.good = VertexSet(triangulation.num_vertices(), 1);
  marks.reached = std::move(out);
  return marks;
}

// Vertices of the boundary with a cell there that is new or on another side than before.
std::set<VertexId> touched_vertices(const Triangulation& triangulation,
                                    const IdVector<CellId, std::uint8_t>& out,
                                    const std::set<CellCorners>& old_cells,
                                    const std::set<CellCorners>& body_before) {
  std::set<VertexId> touched;
  for (const CellId c : triangulation.cells()) {
    const CellCorners corners = corners_of_cell(triangulation, c);
    if (old_cells.contains(corners) && body_before.contains(corners) == (out[c] == 0)) continue;
    for (int i = 0; i < 4; ++i) {
      if (out[c] == out[triangulation.neighbor(c, i)]) continue;
      for (const VertexId v : triangulation.facet_vertices(facet_id(c, i))) touched.insert(v);
    }
  }
  return touched;
}

std::set<Corners> triangles_at(const std::set<VertexId>& vertices,
                               const std::set<Corners>& boundary) {
  std::set<Corners> found;
  for (const Corners& corners : boundary) {
    if (std::any_of(corners.begin(), corners.end(),
                    [&](VertexId v) { return vertices.contains(v); })) {
      found.insert(corners);
    }
  }
  return found;
}

TEST(KeptBody, TellsWhatAChangeDoesToTheBoundary) {
  Random random(5);
  ChangingBall ball(400);
  KeptBody kept;
  std::set<CellCorners> body;
  std::map<Point, std::set<CornerPoints>> before;
  const auto compare =
      [&](const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
          const std::set<Corners>& boundary, const std::map<Point, std::set<CornerPoints>>& now) {
        ASSERT_TRUE(kept.exists());
        const KeptBody::Change change = kept.change_to(triangulation, out);
        const std::set<VertexId> touched(change.touched.begin(), change.touched.end());
        ASSERT_EQ(touched.size(), change.touched.size());
        ASSERT_TRUE(touched == touched_vertices(triangulation, out, ball.old_cells(), body));
        for (const VertexId v : triangulation.vertices()) {
          if (touched.contains(v)) continue;
          ASSERT_TRUE(now.at(triangulation.point(v)) == before.at(triangulation.point(v)));
        }
        std::set<Corners> triangles;
        for (const Corners& corners : change.triangles) {
          ASSERT_TRUE(triangles.insert(smallest_corner_first(corners)).second);
        }
        ASSERT_TRUE(triangles == triangles_at(touched, boundary));
      };
  for (std::size_t step = 0; step < 25 * test::long_factor(); ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    if (step > 0) ball.change(random, kept);
    ball.lend([&](const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at) {
      const IdVector<CellId, std::uint8_t> out = body_out(triangulation, random);
      const std::set<Corners> boundary = boundary_of(triangulation, out);
      std::map<Point, std::set<CornerPoints>> now = by_point(triangulation, boundary);
      if (step > 0) compare(triangulation, out, boundary, now);
      kept.keep(triangulation, cell_at, marks_of(triangulation, out));
      before = std::move(now);
      body.clear();
      for (const CellId c : triangulation.cells()) {
        if (out[c] == 0) body.insert(corners_of_cell(triangulation, c));
      }
    });
    ball.keep();
    if (HasFatalFailure()) return;
  }
}

TEST(KeptBody, NothingIsTouchedWhereNothingChanges) {
  Random random(6);
  ChangingBall ball(200);
  ball.lend([&](const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at) {
    const IdVector<CellId, std::uint8_t> out = body_out(triangulation, random);
    KeptBody kept;
    kept.keep(triangulation, cell_at, marks_of(triangulation, out));
    const KeptBody::Change change = kept.change_to(triangulation, out);
    EXPECT_TRUE(change.touched.empty());
    EXPECT_TRUE(change.triangles.empty());
  });
}

// Whoever is not good must have a facet of the boundary with one that is.
TEST(KeptBody, IsNotKeptIfItsBoundaryMayBeInParts) {
  Random random(7);
  ChangingBall ball(200);
  ball.lend([&](const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at) {
    CellMarks marks = marks_of(triangulation, body_out(triangulation, random));
    const VertexId v(std::size_t{17});
    KeptBody kept;
    marks.good[v] = 0;
    kept.keep(triangulation, cell_at, marks);
    EXPECT_TRUE(kept.exists());
    for (const Corners& corners : boundary_of(triangulation, marks.reached)) {
      if (std::find(corners.begin(), corners.end(), v) == corners.end()) continue;
      for (const VertexId w : corners) marks.good[w] = 0;
    }
    kept.keep(triangulation, cell_at, marks);
    EXPECT_FALSE(kept.exists());
  });
}

}  // namespace
}  // namespace cocoon
