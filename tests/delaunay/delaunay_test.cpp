// The kernel against its oracles: equal cells on generic and on degenerate points.
#include "delaunay/delaunay.h"

#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/check_delaunay.h"
#include "geom/errors.h"
#include "ref/brute_force_delaunay.h"
#include "ref/cell_set.h"
#include "ref/cgal_delaunay.h"
#include "tests/gallery.h"
#include "tests/named_set.h"

namespace cocoon {
namespace {

std::vector<NamedSet> oracle_sets() {
  using namespace gallery;
  return {
      {"one_tetrahedron",
       [] {
         return std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
       }},
      {"cube_corners", [] { return integer_grid(2); }},
      {"uniform_10", [] { return uniform_cube(10); }},
      {"uniform_100", [] { return uniform_cube(100); }},
      {"uniform_1000", [] { return uniform_cube(1000); }},
      {"uniform_10000", [] { return uniform_cube(10000); }},
      {"uniform_100000", [] { return uniform_cube(100000); }},
      {"sphere_1000", [] { return sphere(1000); }},
      {"sphere_20000", [] { return sphere(20000); }},
      {"torus_30000", [] { return displaced_torus(30000); }},
      {"torus_exact_2000", [] { return displaced_torus(2000, 2, 0); }},
      {"bumpy_sphere_30000", [] { return bumpy_sphere(30000); }},
      {"clusters_20000", [] { return clusters(20000); }},
      {"grid_3", [] { return integer_grid(3); }},
      {"grid_10", [] { return integer_grid(10); }},
      {"grid_30", [] { return integer_grid(30); }},
      {"grid_20_shuffled", [] { return shuffled(integer_grid(20)); }},
      {"integer_sphere_1105", [] { return integer_sphere(1105); }},
      {"integer_sphere_and_center",
       [] {
         std::vector<Point> points = integer_sphere(1105);
         points.push_back({0, 0, 0});
         return points;
       }},
      // Integers whose determinants have more digits than a double.
      {"large_integer_sphere", [] { return scaled(integer_sphere(1105), 61); }},
      {"larger_integer_sphere", [] { return scaled(integer_sphere(1105), 6007); }},
      {"box_faces", [] { return box_faces(12); }},
      {"box_faces_not_dyadic", [] { return box_faces(10); }},
      {"plane_and_apex", [] { return plane_and_apex(30); }},
      {"cylinder", [] { return cylinder(12); }},
      {"two_lines", [] { return two_lines(60); }},
      {"ulp_pairs", [] { return ulp_pairs(2000); }},
      {"ulp_grids", [] { return ulp_grids(20); }},
      {"shifted_1e7",
       [] {
         return shifted(uniform_cube(5000), {1e7, -1e7, 1e7});
       }},
      {"shifted_1e15",
       [] {
         return shifted(scaled(uniform_cube(3000), 100), {1e15, 1e15, 1e15});
       }},
      {"flat_by_1e9",
       [] {
         std::vector<Point> points = uniform_cube(5000);
         for (Point& p : points) p.z *= 1e-9;
         return points;
       }},
      {"needle_1e9",
       [] {
         std::vector<Point> points = uniform_cube(5000);
         for (Point& p : points) p.x *= 1e9;
         return points;
       }},
      {"duplicates", [] { return shuffled(repeated(uniform_cube(2000), 3)); }},
      {"grid_duplicates", [] { return shuffled(repeated(integer_grid(6), 4)); }},
      {"signed_zeros",
       [] {
         return std::vector<Point>{{0.0, 0, 0}, {-0.0, 0, 0}, {1, 0, -0.0},
                                   {0, 1, 0},   {-0.0, 0, 1}, {1, 0, 0.0}};
       }},
      {"mixed_scales",
       [] {
         std::vector<Point> points = uniform_cube(1000);
         for (const double scale : {1e-3, 1e-6, 1e-9, 1e-12}) {
           for (const Point& p : uniform_cube(500, 3)) points.push_back(scale * p);
         }
         return points;
       }},
      {"scan_poste_france",
       [] { return read_xyz(std::string(COCOON_TEST_DATA) + "/poste_france.xyz"); }},
  };
}

class DelaunayOracle : public testing::TestWithParam<NamedSet> {};

TEST_P(DelaunayOracle, SameCellsAsCgal) {
  const std::vector<Point> points = GetParam().make();
  const DelaunayResult result = delaunay(points);
  const Triangulation oracle = ref::cgal_delaunay(points);
  EXPECT_EQ(result.triangulation.num_vertices(), oracle.num_vertices());
  EXPECT_EQ(result.triangulation.num_duplicates(), oracle.num_duplicates());
  EXPECT_EQ(result.triangulation.num_finite_cells(), oracle.num_finite_cells());
  EXPECT_EQ(result.triangulation.num_cells(), oracle.num_cells());
  EXPECT_TRUE(ref::cell_set(result.triangulation) == ref::cell_set(oracle));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const VertexId v = result.triangulation.vertex_of_point()[PointId(i)];
    ASSERT_EQ(result.triangulation.point(v), points[i]) << "point " << i;
  }
}

TEST_P(DelaunayOracle, PassesTheCheck) {
  const DelaunayResult result = delaunay(GetParam().make());
  const DelaunayReport report = check_delaunay(result.triangulation, {.threads = 2});
  EXPECT_TRUE(report.ok()) << report.first_violation;
}

// Not only the same cells: the same arrays, for another input order, another insertion order and
// more threads.
TEST_P(DelaunayOracle, SameBytesForEveryInputOrderAndThreadCount) {
  const std::vector<Point> points = GetParam().make();
  const Triangulation expected = canonical_order(delaunay(points).triangulation);
  for (const std::uint64_t seed : {11, 12}) {
    const std::vector<Point> other = gallery::shuffled(points, seed);
    const Triangulation actual = canonical_order(
        delaunay(other, {.seed = seed}, {.threads = seed == 11 ? 1 : 2}).triangulation);
    EXPECT_TRUE(actual.points() == expected.points());
    EXPECT_TRUE(actual.cell_records() == expected.cell_records());
    EXPECT_EQ(actual.num_finite_cells(), expected.num_finite_cells());
  }
}

INSTANTIATE_TEST_SUITE_P(Gallery, DelaunayOracle, testing::ValuesIn(oracle_sets()), name_of);

// --- Against the definition --------------------------------------------------------------------

TEST(Delaunay, SameCellsAsBruteForceOnSmallSets) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    // Few integer values: most of the tuples are coplanar or cospherical.
    std::vector<Point> points(12 + random.below(8));
    for (Point& p : points) {
      for (double* coordinate : {&p.x, &p.y, &p.z}) {
        *coordinate = static_cast<double>(random.below(4));
      }
    }
    points.push_back({0, 0, 0});
    points.push_back({3, 0, 0});
    points.push_back({0, 3, 0});
    points.push_back({0, 0, 3});
    EXPECT_EQ(ref::cell_set(delaunay(points).triangulation),
              ref::cell_set(ref::brute_force_delaunay(points)))
        << "seed " << seed;
  }
}

TEST(Delaunay, SameCellsAsBruteForceOnThirtyRandomPoints) {
  const std::vector<Point> points = gallery::uniform_cube(30, 5);
  EXPECT_EQ(ref::cell_set(delaunay(points).triangulation),
            ref::cell_set(ref::brute_force_delaunay(points)));
}

// --- Scales --------------------------------------------------------------------------------------

// A power of two changes no significand: the cells stay, whatever the exponents do.
TEST(Delaunay, PowersOfTwoDoNotChangeTheCells) {
  for (const auto& make : {gallery::uniform_cube(2000), gallery::integer_grid(8),
                           gallery::sphere(1000), gallery::ulp_pairs(300)}) {
    const auto expected = ref::cell_set(ref::cgal_delaunay(make));
    for (const double factor : {0x1p-500, 0x1p-180, 0x1p180, 0x1p498}) {
      const DelaunayResult result = delaunay(gallery::scaled(make, factor));
      EXPECT_TRUE(ref::cell_set(result.triangulation) == expected) << "factor " << factor;
    }
  }
}

TEST(Delaunay, DecimalScalesPassTheCheck) {
  for (const double factor : {1e-150, 1e-100, 1e-12, 1e12, 1e100, 1e150}) {
    for (const auto& make :
         {gallery::uniform_cube(1000), gallery::integer_grid(7), gallery::sphere(500)}) {
      const DelaunayResult result = delaunay(gallery::scaled(make, factor));
      const DelaunayReport report = check_delaunay(result.triangulation);
      EXPECT_TRUE(report.ok()) << factor << ": " << report.first_violation;
    }
  }
}

// --- Duplicates, counters, progress --------------------------------------------------------------

TEST(Delaunay, EqualPointsShareOneVertex) {
  std::vector<Point> points = gallery::uniform_cube(50);
  points.push_back(points[7]);
  points.push_back(points[7]);
  const Triangulation triangulation = delaunay(points).triangulation;
  EXPECT_EQ(triangulation.num_vertices(), 50U);
  EXPECT_EQ(triangulation.num_duplicates(), 2U);
  const VertexId v = triangulation.vertex_of_point()[PointId(7)];
  EXPECT_EQ(triangulation.vertex_of_point()[PointId(50)], v);
  EXPECT_EQ(triangulation.vertex_of_point()[PointId(51)], v);
  EXPECT_EQ(triangulation.point_of_vertex(v), PointId(7));
}

TEST(Delaunay, CountersCount) {
  const DelaunayResult result = delaunay(gallery::uniform_cube(2000));
  const DelaunayCounters& c = result.counters;
  // All cells but the five that the build starts with are created by an insertion.
  EXPECT_EQ(c.cells_created + 5, result.triangulation.num_cells() + c.cells_deleted);
  // Every insertion deletes the cell it starts from untested, and those that failed the test.
  EXPECT_GE(c.conflict_tests + 1996, c.cells_deleted);
  EXPECT_GT(c.walk_steps, 0U);
  EXPECT_EQ(c.perturbed_inspheres, 0U);
}

TEST(Delaunay, CountersTellWhichLevelDecided) {
  // Small integers: the filter's value is exact, ties are known at once.
  const DelaunayCounters grid = delaunay(gallery::integer_grid(8)).counters;
  EXPECT_EQ(grid.exact_inspheres, 0U);
  EXPECT_GT(grid.perturbed_inspheres, 0U);
  // Points rounded onto a sphere: nearly cospherical, far below the filter's bound.
  const DelaunayCounters sphere = delaunay(gallery::sphere(500)).counters;
  EXPECT_GT(sphere.wide_inspheres, 0U);
  EXPECT_EQ(sphere.exact_inspheres, 0U);
  EXPECT_EQ(sphere.perturbed_inspheres, 0U);
}

class StopAtOnce : public Progress {
 public:
  bool report(std::string_view, double) override { return false; }
};

TEST(Delaunay, ReportsProgressAndCanBeCancelled) {
  class Recorder : public Progress {
   public:
    bool report(std::string_view stage, double fraction) override {
      EXPECT_EQ(stage, "delaunay");
      EXPECT_GE(fraction, last);
      last = fraction;
      ++calls;
      return true;
    }
    double last = 0;
    int calls = 0;
  } recorder;
  const std::vector<Point> points = gallery::uniform_cube(1000);
  delaunay(points, {}, {.progress = &recorder});
  EXPECT_EQ(recorder.last, 1);
  EXPECT_GE(recorder.calls, 2);

  StopAtOnce stop;
  EXPECT_THROW(delaunay(points, {}, {.progress = &stop}), Cancelled);
}

// --- Input that has no triangulation ----------------------------------------------------------

// The message of the InputError; fails if there is none.
std::string error_of(const std::vector<Point>& points) {
  try {
    delaunay(points);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  }
  ADD_FAILURE() << "no InputError for " << points.size() << " points";
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DelaunayErrors, FewerThanFourDifferentPoints) {
  EXPECT_TRUE(contains(error_of({}), "at least 4"));
  EXPECT_TRUE(contains(error_of({{1, 2, 3}}), "only 1 different point: "));
  EXPECT_TRUE(contains(error_of(gallery::repeated({{1, 2, 3}}, 5)), "only 1 different point: "));
  EXPECT_TRUE(
      contains(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "at least 4; give more points"));
  EXPECT_TRUE(
      contains(error_of(gallery::repeated({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 5)), "at least 4"));
}

TEST(DelaunayErrors, Coplanar) {
  std::vector<Point> flat = gallery::uniform_cube(10000);
  for (Point& p : flat) p.z = 0.25;
  EXPECT_TRUE(contains(error_of(flat), "plane"));
  // A tilted plane, on which the points lie exactly.
  std::vector<Point> tilted = gallery::plane_and_apex(20);
  tilted.pop_back();
  for (Point& p : tilted) p.z = 3 * p.x - 2 * p.y + 7;
  EXPECT_TRUE(contains(error_of(tilted), "plane"));
  EXPECT_TRUE(contains(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), "plane"));
}

TEST(DelaunayErrors, Collinear) {
  std::vector<Point> line;
  for (int i = 0; i < 1000; ++i) line.push_back({1.0 * i, 2.0 * i, -3.0 * i});
  EXPECT_TRUE(contains(error_of(line), "needs points off the line"));
  std::vector<Point> axis;
  for (int i = 0; i < 1000; ++i) axis.push_back({0, 0.1 * i, 0});
  EXPECT_FALSE(error_of(axis).empty());
}

TEST(DelaunayErrors, NotFiniteNamesTheFirstPoint) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {infinity, -infinity, nan}) {
    std::vector<Point> points = gallery::uniform_cube(100);
    points[37].y = bad;
    points[73].z = bad;
    const std::string message = error_of(points);
    EXPECT_TRUE(contains(message, "37")) << message;
    EXPECT_FALSE(contains(message, "73")) << message;
  }
}

// Coplanar but for one point by one unit in the last place: has cells, no error.
TEST(DelaunayErrors, OneUlpOffThePlaneIsEnough) {
  std::vector<Point> points = gallery::plane_and_apex(6);
  points.back() = {2, 3, 1};
  for (Point& p : points) p.z += 1;
  points.back().z = std::nextafter(1.0, 2.0);
  const Triangulation triangulation = delaunay(points).triangulation;
  const DelaunayReport report = check_delaunay(triangulation);
  EXPECT_TRUE(report.ok()) << report.first_violation;
  EXPECT_TRUE(ref::cell_set(triangulation) == ref::cell_set(ref::cgal_delaunay(points)));
}

}  // namespace
}  // namespace cocoon
