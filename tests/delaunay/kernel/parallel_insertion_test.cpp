// Insertion on several threads: the same cells as on one, whatever the points and the threads.
#include "delaunay/kernel/parallel_insertion.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/delaunay.h"
#include "delaunay/kernel/cavity.h"
#include "delaunay/kernel/cell_pool.h"
#include "delaunay/kernel/first_cells.h"
#include "delaunay/kernel/vertex_claims.h"
#include "geom/errors.h"
#include "geom/spatial_order.h"
#include "tests/gallery.h"
#include "tests/named_set.h"

namespace cocoon {
namespace {

// All points but the first four on several threads from the start, when every insertion is in the
// way of every other. Precondition: the points are different, some four of the first span space.
Triangulation insert_all_in_parallel(const std::vector<Point>& given, int threads,
                                     DelaunayCounters& counters) {
  TriangulationArrays arrays;
  arrays.vertex_of_point.resize(given.size());
  for (const PointId p : hilbert_order(given)) {
    arrays.vertex_of_point[p] = arrays.points.push_back(given[p.index()]);
  }
  IdVector<VertexId, Point> points = arrays.points;
  points.push_back({});
  InsertionRounds rounds = insertion_rounds(given.size(), 1);
  EXPECT_EQ(bring_simplex_to_front(arrays.points, rounds.order), 3);
  const auto corner = [&](std::size_t i) { return VertexId(rounds.order[i]); };
  CellPool pool;
  make_first_cells(pool, points, {corner(0), corner(1), corner(2), corner(3)});
  const CavityInserter first_inserter(pool, points);
  insert_in_parallel(pool, points, first_inserter, rounds.order, rounds.ends, 4, counters,
                     {.threads = threads});
  const std::size_t finite_cells = compact_cells(pool);
  arrays.cells = std::move(pool.cells);
  return canonical_order(Triangulation(std::move(arrays), finite_cells));
}

std::vector<NamedSet> crowded_sets() {
  using namespace gallery;
  return {
      {"ten_points", [] { return uniform_cube(10); }},
      {"uniform", [] { return uniform_cube(3000); }},
      {"sphere", [] { return sphere(1500); }},
      {"torus", [] { return displaced_torus(3000); }},
      {"clusters", [] { return clusters(2000); }},
      {"grid", [] { return integer_grid(11); }},
      {"integer_sphere", [] { return integer_sphere(1105); }},
      {"plane_and_apex", [] { return plane_and_apex(25); }},
      {"two_lines", [] { return two_lines(50); }},
      {"ulp_pairs", [] { return ulp_pairs(700); }},
      {"ulp_grids", [] { return ulp_grids(15); }},
  };
}

class CrowdedInsertion : public testing::TestWithParam<NamedSet> {};

TEST_P(CrowdedInsertion, SameCellsAsOneThread) {
  std::vector<Point> points = GetParam().make();
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const DelaunayResult one = delaunay(points);
  const Triangulation expected = canonical_order(one.triangulation);
  for (const int threads : {1, 2, 5, 8}) {
    DelaunayCounters counters;
    const Triangulation actual = insert_all_in_parallel(points, threads, counters);
    EXPECT_TRUE(actual.points() == expected.points());
    EXPECT_TRUE(actual.cell_records() == expected.cell_records()) << threads << " threads";
    EXPECT_EQ(counters.cells_created + 5, actual.num_cells() + counters.cells_deleted);
    if (threads == 1) {
      EXPECT_EQ(counters.retries + counters.stolen_runs, 0U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gallery, CrowdedInsertion, testing::ValuesIn(crowded_sets()), name_of);

// More points, so that the public function uses its threads.
std::vector<NamedSet> large_sets() {
  using namespace gallery;
  return {
      {"uniform", [] { return uniform_cube(30000); }},
      {"sphere", [] { return sphere(12000); }},
      {"torus", [] { return displaced_torus(20000); }},
      {"bumpy_sphere", [] { return bumpy_sphere(20000); }},
      {"clusters", [] { return clusters(15000); }},
      {"grid", [] { return integer_grid(24); }},
      {"box_faces", [] { return box_faces(16); }},
      {"duplicates", [] { return shuffled(repeated(uniform_cube(12000), 2)); }},
      {"scan",
       [] {
         std::vector<Point> points = read_xyz(std::string(COCOON_TEST_DATA) + "/poste_france.xyz");
         for (Point p : read_xyz(std::string(COCOON_TEST_DATA) + "/poste_france.xyz")) {
           points.push_back(p + Vec3{0.01, 0.02, 0.03});
         }
         return points;
       }},
  };
}

class ThreadedDelaunay : public testing::TestWithParam<NamedSet> {};

TEST_P(ThreadedDelaunay, SameBytesForEveryThreadCount) {
  const std::vector<Point> points = GetParam().make();
  const Triangulation expected = canonical_order(delaunay(points).triangulation);
  ASSERT_GE(expected.num_vertices(), 10000U);
  for (const int threads : {2, 3, 4, 8}) {
    const Triangulation actual = canonical_order(
        delaunay(gallery::shuffled(points), {.seed = 7}, {.threads = threads}).triangulation);
    EXPECT_TRUE(actual.points() == expected.points()) << threads << " threads";
    EXPECT_TRUE(actual.cell_records() == expected.cell_records()) << threads << " threads";
    EXPECT_EQ(actual.num_finite_cells(), expected.num_finite_cells());
  }
}

INSTANTIATE_TEST_SUITE_P(Gallery, ThreadedDelaunay, testing::ValuesIn(large_sets()), name_of);

TEST(ThreadedDelaunay, PassesTheCheckUnderStress) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Point> points =
        seed % 2 == 0 ? gallery::uniform_cube(12000, seed) : gallery::displaced_torus(12000, seed);
    const DelaunayResult result =
        delaunay(points, {.seed = seed}, {.threads = 2 + static_cast<int>(seed % 7)});
    const DelaunayReport report = check_delaunay(result.triangulation);
    EXPECT_TRUE(report.ok()) << seed << ": " << report.first_violation;
  }
}

// Points on two lines have many more cells than a round makes room for.
TEST(ThreadedDelaunay, MakesRoomForAnyNumberOfCells) {
  std::vector<Point> points = gallery::two_lines(400);
  DelaunayCounters counters;
  const Triangulation actual = insert_all_in_parallel(points, 4, counters);
  EXPECT_GT(actual.num_cells(), 100 * points.size());
  EXPECT_TRUE(actual.cell_records() ==
              canonical_order(delaunay(points).triangulation).cell_records());
}

TEST(ThreadedDelaunay, CanBeCancelledWhileThreadsWork) {
  class StopLater : public Progress {
   public:
    bool report(std::string_view, double fraction) override { return fraction < 0.3; }
  } stop;
  const std::vector<Point> points = gallery::uniform_cube(100000);
  EXPECT_THROW(delaunay(points, {}, {.threads = 3, .progress = &stop}), Cancelled);
}

// --- Claims --------------------------------------------------------------------------------------

TEST(VertexClaims, OneHolderAtATime) {
  for (const unsigned block_bits : {0U, 3U}) {
    VertexClaims claims(100, block_bits);
    const VertexId v(40);
    const VertexId far(60);
    ClaimHolder first(claims, 0);
    ClaimHolder last(claims, VertexClaims::max_holders - 1);
    EXPECT_FALSE(first.holds(v));
    EXPECT_TRUE(first.take(v));
    EXPECT_TRUE(first.take(v)) << "again";
    EXPECT_TRUE(first.holds(v));
    EXPECT_EQ(first.num_held(), 1U);
    EXPECT_FALSE(last.take(v));
    EXPECT_TRUE(last.take(far));
    EXPECT_EQ(last.take(VertexId(41)), block_bits == 0) << "the block of 40";
    EXPECT_TRUE(first.take(infinite_vertex));
    EXPECT_TRUE(last.take(infinite_vertex));
    EXPECT_FALSE(first.holds(infinite_vertex)) << "counts as held without being so";
    first.release();
    EXPECT_TRUE(last.take(v));
    EXPECT_FALSE(first.take(v));
  }
}

TEST(VertexClaims, TheLastVertexIsNotTheOneAtInfinity) {
  for (const std::size_t count : {1U, 7U, 8U, 9U}) {
    VertexClaims claims(count, 3);
    ClaimHolder holder(claims, 0);
    EXPECT_TRUE(holder.take(VertexId(count - 1)));
    EXPECT_TRUE(holder.holds(VertexId(count - 1)));
    EXPECT_FALSE(holder.holds(infinite_vertex));
  }
}

TEST(VertexClaims, ReleaseAllButOneCell) {
  VertexClaims claims(8, 0);
  ClaimHolder holder(claims, 0);
  ClaimHolder other(claims, 1);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(holder.take(VertexId(i)));
  holder.release_but({{VertexId(2), VertexId(7), VertexId(4), infinite_vertex}, {}});
  EXPECT_EQ(holder.num_held(), 3U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(other.take(VertexId(i)), i != 2 && i != 4 && i != 7) << i;
  }
}

// --- Numbers -------------------------------------------------------------------------------------

TEST(CellNumbers, TheLastCellHasFourFacetsThatAreNotNone) {
  const CellId last(max_cells - 1);
  for (int i = 0; i < 4; ++i) {
    const FacetId facet = facet_id(last, i);
    EXPECT_FALSE(facet.is_none());
    EXPECT_EQ(cell_of(facet), last);
    EXPECT_EQ(index_of(facet), i);
  }
  EXPECT_TRUE(facet_id(CellId(max_cells), 3).is_none());
  EXPECT_NO_THROW(require_cell_numbers(max_cells));
  EXPECT_THROW(require_cell_numbers(max_cells + 1), InputError);
}

// No memory of that size is needed: what is too much is said before anything is read.
TEST(CellNumbers, MorePointsThanIdsIsAnError) {
  const Point point{};
  EXPECT_THROW(delaunay(Points(&point, infinite_vertex.value)), InputError);
  EXPECT_THROW(delaunay(Points(&point, std::size_t{1} << 40)), InputError);
}

}  // namespace
}  // namespace cocoon
