// Any history of insertions and removals against a fresh triangulation of the same points.
#include "delaunay/dynamic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/delaunay/dynamic_checks.h"
#include "tests/gallery.h"
#include "tests/named_set.h"
#include "tests/stop_after.h"

namespace cocoon {
namespace {

std::vector<NamedSet> sets() {
  using namespace gallery;
  return {
      {"uniform", [] { return uniform_cube(600); }},
      {"sphere", [] { return sphere(500); }},
      {"bumpy_sphere", [] { return bumpy_sphere(1500); }},
      {"clusters", [] { return clusters(600); }},
      {"grid", [] { return integer_grid(8); }},
      {"integer_sphere", [] { return integer_sphere(1105); }},
      {"box_faces", [] { return box_faces(4); }},
      {"plane_between_apexes",
       [] {
         std::vector<Point> points = plane_and_apex(12);
         for (int i = 0; i < 20; ++i) {
           points.push_back({0.5 * i, 0.25 * (i % 7), i % 2 == 0 ? 3.0 : -4.0});
         }
         return points;
       }},
      {"cylinder", [] { return cylinder(6); }},
      {"two_lines", [] { return two_lines(50); }},
      {"ulp_pairs", [] { return ulp_pairs(200); }},
      {"ulp_grids", [] { return ulp_grids(8); }},
      {"duplicates", [] { return shuffled(repeated(uniform_cube(200), 3)); }},
      {"grid_duplicates", [] { return shuffled(repeated(integer_grid(5), 3)); }},
  };
}

class DynamicGallery : public testing::TestWithParam<NamedSet> {};

// In three batches into an empty one, or into a triangulation that was taken over.
TEST_P(DynamicGallery, InsertionEqualsAFreshBuild) {
  const std::vector<Point> points = gallery::shuffled(GetParam().make(), 5);
  const std::size_t half = points.size() / 2;
  const Points all(points);
  DynamicDelaunay grown;
  grown.insert(all.first(half));
  expect_fresh(grown);
  DynamicDelaunay taken(delaunay(all.first(half)).triangulation);
  for (DynamicDelaunay* dynamic : {&grown, &taken}) {
    const auto before = cells_by_slot(*dynamic);
    const DelaunayChange change = dynamic->insert(all.subspan(half));
    expect_journal(before, *dynamic, change);
    expect_consistent(*dynamic);
    expect_fresh(*dynamic);
    ASSERT_EQ(change.vertex_of_point.size(), points.size() - half);
    for (std::size_t i = half; i < points.size(); ++i) {
      ASSERT_EQ(dynamic->point(change.vertex_of_point[i - half]), points[i]);
    }
    EXPECT_EQ(change.duplicates + change.inserted.size(), points.size() - half);
  }
}

TEST_P(DynamicGallery, RemovalOneByOneEqualsAFreshBuild) {
  DynamicDelaunay dynamic;
  dynamic.insert(GetParam().make());
  std::vector<VertexId> live = live_vertices(dynamic);
  Random(3).shuffle(live);
  for (int k = 0; k < 40; ++k) {
    const auto before = cells_by_slot(dynamic);
    const std::vector<VertexId> removed(live.end() - 1, live.end());
    live.pop_back();
    const DelaunayChange change = dynamic.remove(removed);
    EXPECT_EQ(change.removal.holes, 1U);
    expect_journal(before, dynamic, change);
    if (k % 8 == 0) expect_fresh(dynamic);
  }
  expect_consistent(dynamic);
  expect_fresh(dynamic);
}

TEST_P(DynamicGallery, RemovalOfManyAtOnceEqualsAFreshBuild) {
  for (const double share : {0.1, 0.5, 0.9}) {
    DynamicDelaunay dynamic;
    dynamic.insert(GetParam().make());
    std::vector<VertexId> live = live_vertices(dynamic);
    Random(4).shuffle(live);
    live.resize(static_cast<std::size_t>(share * static_cast<double>(live.size())));
    const auto before = cells_by_slot(dynamic);
    const DelaunayChange change = dynamic.remove(live);
    EXPECT_EQ(change.removed.size(), live.size());
    expect_journal(before, dynamic, change);
    expect_consistent(dynamic);
    expect_fresh(dynamic);
  }
}

// A patch around one vertex, inside and on the hull, is removed and comes back.
TEST_P(DynamicGallery, WhatComesBackIsWhatWasThere) {
  DynamicDelaunay dynamic;
  dynamic.insert(GetParam().make());
  const Triangulation original = canonical_order(dynamic.freeze().triangulation);
  const std::vector<Point> centers = live_points(dynamic);
  for (const std::size_t at : {std::size_t{0}, centers.size() / 2, centers.size() - 1}) {
    const std::vector<VertexId> removed = patch(dynamic, centers[at], centers.size() / 4);
    std::vector<Point> points;
    for (const VertexId v : removed) points.push_back(dynamic.point(v));
    dynamic.remove(removed);
    expect_fresh(dynamic);
    dynamic.insert(points);
    const Triangulation restored = canonical_order(dynamic.freeze().triangulation);
    ASSERT_TRUE(restored.points() == original.points());
    ASSERT_TRUE(restored.cell_records() == original.cell_records());
  }
}

TEST_P(DynamicGallery, ReplacementEqualsAFreshBuild) {
  const std::vector<Point> points = GetParam().make();
  const std::size_t half = points.size() / 2;
  const std::vector<Point> shuffled = gallery::shuffled(points, 6);
  const Points all(shuffled);
  DynamicDelaunay dynamic;
  dynamic.insert(all.first(half));
  const auto before = cells_by_slot(dynamic);
  const std::vector<VertexId> removed = patch(dynamic, shuffled[0], half / 3);
  const DelaunayChange change = dynamic.replace(removed, all.subspan(half / 2));
  expect_journal(before, dynamic, change);
  expect_consistent(dynamic);
  expect_fresh(dynamic);
}

// Arrays by slot that follow the renumbering belong to the same elements as before, and what is
// lent and comes back is what was there.
void expect_no_gaps_after_closing(DynamicDelaunay& dynamic) {
  std::vector<std::vector<VertexId>> cells = cells_by_slot(dynamic);
  std::vector<Point> points;
  for (const VertexId v : id_range<VertexId>(dynamic.num_vertex_slots())) {
    points.push_back(dynamic.contains(v) ? dynamic.point(v) : Point{});
  }
  const Renumbering renumbering = dynamic.close_gaps();
  for (const auto& [a, b] : renumbering.cells) std::swap(cells[a.index()], cells[b.index()]);
  for (const auto& [from, to] : renumbering.vertices) {
    points[to.index()] = points[from.index()];
    for (std::vector<VertexId>& cell : cells) {
      std::replace(cell.begin(), cell.end(), from, to);
      std::sort(cell.begin(), cell.end());
    }
  }
  cells.resize(dynamic.view().cell_records().size());
  points.resize(dynamic.num_vertex_slots());
  ASSERT_EQ(cells, cells_by_slot(dynamic));
  ASSERT_EQ(live_points(dynamic), points);
  ASSERT_EQ(dynamic.num_vertices(), points.size());
  expect_consistent(dynamic);

  IdVector<PointId, VertexId> vertex_of_point;
  for (const VertexId v : live_vertices(dynamic)) vertex_of_point.push_back(v);
  const IdVector<CellId, Cell> records = dynamic.view().cell_records();
  Triangulation lent = dynamic.lend(vertex_of_point);
  EXPECT_EQ(lent.cell_records(), records);
  EXPECT_EQ(lent.points().raw(), points);
  for (const CellId c : lent.cells()) {
    ASSERT_EQ(lent.is_infinite(c), is_infinite(lent.cell(c)));
  }
  EXPECT_EQ(dynamic.take_back(std::move(lent)), vertex_of_point);
  ASSERT_EQ(live_points(dynamic), points);
}

// Random operations of random size; the set stays small, so that it is often nearly nothing.
TEST_P(DynamicGallery, LongHistoriesEndInTheSameCells) {
  const std::vector<Point> pool = GetParam().make();
  Random random(7);
  DynamicDelaunay dynamic;
  std::size_t refused = 0;
  for (int step = 0; step < 700; ++step) {
    const std::vector<VertexId> live = live_vertices(dynamic);
    std::vector<VertexId> removed;
    std::vector<Point> inserted;
    const std::size_t largest = step % 10 == 0 ? 40 : 4;
    if (random.below(5) != 0) {
      for (std::size_t k = random.below(largest); k-- > 0;) {
        inserted.push_back(pool[random.below(pool.size())]);
      }
    }
    if (random.below(3) != 0 && !live.empty()) {
      for (std::size_t k = random.below(largest); k-- > 0;) {
        removed.push_back(live[random.below(live.size())]);
      }
    }
    const auto before = cells_by_slot(dynamic);
    try {
      const DelaunayChange change = dynamic.replace(removed, inserted);
      expect_journal(before, dynamic, change);
    } catch (const InputError&) {
      ++refused;
      ASSERT_TRUE(live_vertices(dynamic) == live);
    }
    if (dynamic.num_vertices() > 0 && step % 5 == 0) expect_fresh(dynamic);
    if (step % 7 == 0) expect_no_gaps_after_closing(dynamic);
    if (testing::Test::HasFatalFailure()) FAIL() << "in step " << step;
  }
  expect_consistent(dynamic);
  EXPECT_LT(refused, 350U);
}

INSTANTIATE_TEST_SUITE_P(Gallery, DynamicGallery, testing::ValuesIn(sets()), name_of);

const std::vector<Point> five_points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {5, 5, 5}};

// --- Contract --------------------------------------------------------------------------------

// The center of a sphere has all its points around it: the border of its hole has more facets than
// the table of edges has room for.
TEST(DynamicDelaunay, APointWithAThousandNeighbors) {
  DynamicDelaunay triangulation;
  triangulation.insert(gallery::sphere(1000));
  const std::vector<Point> center{{0, 0, 0}, {3, 0, 0}};
  const DelaunayChange change = triangulation.insert(center);
  EXPECT_GT(change.created.size(), 1900U);
  expect_fresh(triangulation);
  triangulation.remove(change.inserted);
  expect_fresh(triangulation);
}

TEST(DynamicDelaunay, IsASet) {
  DynamicDelaunay dynamic;
  const DelaunayChange first = dynamic.insert(five_points);
  const DelaunayChange again = dynamic.insert(five_points);
  EXPECT_EQ(again.duplicates, 5U);
  EXPECT_TRUE(again.inserted.empty() && again.created.empty() && again.deleted.empty());
  EXPECT_EQ(again.vertex_of_point, first.vertex_of_point);
  dynamic.remove(std::vector{first.vertex_of_point[4], first.vertex_of_point[4]});
  EXPECT_EQ(dynamic.num_vertices(), 4U);
}

// Some of them come twice.
TEST_P(DynamicGallery, VerticesReplacedByThemselvesAreNewVertices) {
  DynamicDelaunay dynamic;
  dynamic.insert(GetParam().make());
  const std::vector<VertexId> removed = patch(dynamic, live_points(dynamic)[0], 150);
  std::vector<Point> points;
  for (const VertexId v : removed) points.push_back(dynamic.point(v));
  const std::size_t twice = points.size() / 3;
  points.insert(points.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(twice));
  const std::size_t vertices = dynamic.num_vertices();
  const auto before = cells_by_slot(dynamic);
  const DelaunayChange change = dynamic.replace(removed, points);
  EXPECT_EQ(dynamic.num_vertices(), vertices);
  EXPECT_EQ(change.removed.size(), removed.size());
  EXPECT_EQ(change.inserted.size(), removed.size());
  EXPECT_EQ(change.duplicates, twice);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(dynamic.point(change.vertex_of_point[i]), points[i]);
  }
  expect_journal(before, dynamic, change);
  expect_consistent(dynamic);
  expect_fresh(dynamic);
}

TEST(DynamicDelaunay, FreezesWithTheMapOfItsVertices) {
  DynamicDelaunay dynamic(delaunay(gallery::uniform_cube(200)).triangulation);
  dynamic.remove(std::vector{VertexId(7), VertexId(0), VertexId(100)});
  const FrozenDelaunay frozen = dynamic.freeze();
  EXPECT_EQ(frozen.triangulation.num_vertices(), 197U);
  EXPECT_TRUE(frozen.frozen_vertex[VertexId(7)].is_none());
  std::size_t point = 0;
  for (const VertexId v : live_vertices(dynamic)) {
    const VertexId number = frozen.frozen_vertex[v];
    EXPECT_EQ(frozen.triangulation.point(number), dynamic.point(v));
    EXPECT_EQ(frozen.triangulation.point_of_vertex(number), PointId(point++));
  }
  EXPECT_TRUE(check_delaunay(frozen.triangulation).ok());
}

// As it was taken over, and after all its vertices were replaced, without close_gaps().
TEST(DynamicDelaunay, LendsWhatItHasJustTakenOver) {
  const std::vector<Point> points = gallery::uniform_cube(200);
  const std::vector<Point> others = gallery::uniform_cube(100, 9);
  DynamicDelaunay dynamic(delaunay(points).triangulation);
  for (const std::vector<Point>& taken : {points, others}) {
    if (taken == others) dynamic.replace(live_vertices(dynamic), others);
    IdVector<PointId, VertexId> vertex_of_point;
    for (const VertexId v : live_vertices(dynamic)) vertex_of_point.push_back(v);
    Triangulation lent = dynamic.lend(vertex_of_point);
    EXPECT_EQ(lent.num_finite_cells(), delaunay(taken).triangulation.num_finite_cells());
    EXPECT_TRUE(check_delaunay(lent).ok());
    dynamic.take_back(std::move(lent));
  }
}

TEST(DynamicDelaunay, KeepsIdsAndUsesFreeOnesAgain) {
  DynamicDelaunay dynamic;
  dynamic.insert(gallery::uniform_cube(300));
  const std::size_t slots = dynamic.num_vertex_slots();
  const std::vector<VertexId> live = live_vertices(dynamic);
  const std::vector<VertexId> removed(live.begin(), live.begin() + 50);
  const Point kept = dynamic.point(live[60]);
  dynamic.remove(removed);
  const DelaunayChange change = dynamic.insert(gallery::uniform_cube(50, 9));
  EXPECT_EQ(dynamic.num_vertex_slots(), slots);
  EXPECT_EQ(std::set<VertexId>(change.inserted.begin(), change.inserted.end()),
            std::set<VertexId>(removed.begin(), removed.end()));
  EXPECT_EQ(dynamic.point(live[60]), kept);
}

TEST(DynamicDelaunay, RefusalsChangeNothing) {
  DynamicDelaunay dynamic;
  const std::vector<Point> points = gallery::plane_and_apex(6);
  dynamic.insert(points);
  const std::vector<VertexId> live = live_vertices(dynamic);
  const Triangulation original = canonical_order(dynamic.freeze().triangulation);
  const auto expect_unchanged = [&] {
    EXPECT_TRUE(live_vertices(dynamic) == live);
    const Triangulation now = canonical_order(dynamic.freeze().triangulation);
    EXPECT_TRUE(now.cell_records() == original.cell_records());
    expect_consistent(dynamic);
  };
  const VertexId apex =
      *std::find_if(live.begin(), live.end(), [&](VertexId v) { return dynamic.point(v).z != 0; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(dynamic.insert(std::vector<Point>{{0, 0, 1}, {0, nan, 0}}), InputError);
  expect_unchanged();
  EXPECT_THROW(dynamic.remove(std::vector{live[3], VertexId(999)}), InputError);
  EXPECT_THROW(dynamic.remove(std::vector{VertexId()}), InputError);
  EXPECT_THROW(dynamic.remove(std::vector{infinite_vertex}), InputError);
  expect_unchanged();
  EXPECT_THROW(dynamic.remove(std::vector{apex}), InputError);
  EXPECT_THROW(dynamic.remove(std::vector<VertexId>(live.begin() + 3, live.end())), InputError);
  EXPECT_THROW(dynamic.replace(std::vector{apex}, std::vector<Point>{{0.5, 0.5, 0}}), InputError);
  EXPECT_THROW(dynamic.replace(live, gallery::two_lines(1)), InputError);
  expect_unchanged();
  DynamicDelaunay empty;
  EXPECT_THROW(empty.insert(gallery::two_lines(1)), InputError);
  EXPECT_THROW(empty.remove(std::vector{VertexId(0)}), InputError);
  EXPECT_EQ(empty.num_vertices(), 0U);
}

// Replaces, cancelled at each report in turn, until it comes to an end. Returns how often it was.
int replace_cancelled_everywhere(DynamicDelaunay& dynamic, const std::vector<VertexId>& removed,
                                 const std::vector<Point>& inserted) {
  const std::vector<VertexId> live = live_vertices(dynamic);
  const Triangulation original = canonical_order(dynamic.freeze().triangulation);
  const int reports = test::stop_everywhere(
      [&](Progress& progress) { dynamic.replace(removed, inserted, {.progress = &progress}); },
      [&](int) {
        EXPECT_TRUE(live_vertices(dynamic) == live);
        const Triangulation now = canonical_order(dynamic.freeze().triangulation);
        EXPECT_TRUE(now.points() == original.points());
        EXPECT_TRUE(now.cell_records() == original.cell_records());
        expect_consistent(dynamic);
      });
  expect_fresh(dynamic);
  return reports;
}

TEST(DynamicDelaunay, CancellationChangesNothing) {
  DynamicDelaunay dynamic;
  dynamic.insert(gallery::uniform_cube(2000));
  const std::vector<VertexId> removed = patch(dynamic, {0, 0, 0}, 300);
  // The start, two batches, the end.
  EXPECT_GE(replace_cancelled_everywhere(dynamic, removed, gallery::uniform_cube(9000, 8)), 4);
}

// What stays spans space only with the points that come: those that went have to be there again
// before these can go.
TEST(DynamicDelaunay, CancelledAtTheEndWhenWhatStaysIsFlat) {
  DynamicDelaunay dynamic;
  dynamic.insert(gallery::plane_and_apex(6));
  const std::vector<VertexId> live = live_vertices(dynamic);
  const VertexId apex =
      *std::find_if(live.begin(), live.end(), [&](VertexId v) { return dynamic.point(v).z != 0; });
  // The start, the points, the end.
  EXPECT_EQ(replace_cancelled_everywhere(dynamic, {apex}, {{1, 2, 7}, {2, 1, 6}}), 3);
}

// A grid on which values of the filter are exact, and then points far finer.
TEST(DynamicDelaunay, FinerPointsComeLater) {
  for (const double step : {1.0, 0x1p10}) {
    DynamicDelaunay dynamic;
    dynamic.insert(
        gallery::scaled(gallery::shifted(gallery::integer_grid(2), {-0.5, -0.5, -0.5}), 16 * step));
    dynamic.insert(gallery::scaled(gallery::sphere(300), step));
    expect_fresh(dynamic);
    for (const Point& p : gallery::scaled(gallery::sphere(300, 2), step)) {
      dynamic.insert(std::vector{p});
    }
    expect_fresh(dynamic);
  }
}

// Unlike a fresh build it does not scale: where products of the filters underflow, or overflow.
TEST(DynamicDelaunay, TinyAndHugeCoordinates) {
  for (const auto& points : {gallery::sphere(150), gallery::ulp_pairs(60), gallery::integer_grid(5),
                             gallery::box_faces(3), gallery::scaled(gallery::box_faces(2), 0.1)}) {
    for (const int exponent : {-1000, -300, -215, -107, -104, -101, -98, -95, 98, 101, 104, 300}) {
      const std::vector<Point> scaled =
          gallery::shuffled(gallery::scaled(points, std::ldexp(1.0, exponent)));
      DynamicDelaunay dynamic;
      dynamic.insert(Points(scaled).first(20));  // a fresh build
      dynamic.insert(scaled);
      expect_fresh(dynamic);
      dynamic.remove(patch(dynamic, {}, 20));
      expect_fresh(dynamic);
      if (HasFatalFailure()) FAIL() << exponent;
    }
  }
}

TEST(DynamicDelaunay, MovesWithItsMemory) {
  DynamicDelaunay first;
  first.insert(gallery::uniform_cube(50));
  DynamicDelaunay second = std::move(first);
  second.insert(gallery::uniform_cube(50, 2));
  second.remove(std::vector{VertexId(3)});
  expect_fresh(second);
}

}  // namespace
}  // namespace cocoon
