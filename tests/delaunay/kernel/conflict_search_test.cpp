// The search for the cells in conflict with a point, against rational arithmetic: on points that
// sit on the bounds of its filters, and with every instruction set.
#include "delaunay/kernel/conflict_search.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/kernel/first_cells.h"
#include "geom/lanes/vector_dispatch.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"
#include "tests/gallery.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using test::NearDegenerate;

bool all_different(const std::array<Point, 5>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (points[i] == points[k]) return false;
    }
  }
  return true;
}

// The triangulation of four points, and the search for a fifth in it.
class FiveCells {
 public:
  explicit FiveCells(const std::array<Point, 5>& five)
      : points_(std::vector<Point>(five.begin(), five.end())) {
    points_.push_back({});
    make_first_cells(pool_, points_, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  }

  void search() {
    ConflictSearch search(pool_, points_);
    ASSERT_TRUE(search.find_zone(p(), search.find_start(p(), CellId(0), counters_), counters_));
    const ConflictZone& zone = search.zone();
    IdVector<CellId, std::uint8_t> expected;
    for (const Cell& cell : pool_.cells) expected.push_back(in_conflict(cell) ? 1 : 0);
    for (const CellId c : pool_.cells.ids()) {
      const bool found =
          std::find(zone.cells().begin(), zone.cells().end(), c) != zone.cells().end();
      EXPECT_EQ(found, expected[c] == 1) << "cell " << c.value << " of " << p();
      EXPECT_EQ(found, pool_.marks[c] == CellMark::conflict);
      for (const FacetId outer : pool_.cells[c].neighbors) {
        const bool is_border = found && expected[cell_of(outer)] == 0;
        EXPECT_EQ(std::count(zone.border().begin(), zone.border().end(), outer), is_border ? 1 : 0);
      }
    }
  }

  const DelaunayCounters& counters() const { return counters_; }

 private:
  const Point& p() const { return points_[VertexId(4)]; }
  bool in_conflict(const Cell& cell) const {
    const auto corner = [&](const Cell& of, std::size_t i) { return points_[of.vertices[i]]; };
    const Cell* finite = &cell;
    if (is_infinite(cell)) {
      const Sign side = orient3d(corner(cell, 0), corner(cell, 1), corner(cell, 2), p());
      if (side != Sign::zero) return side == Sign::positive;
      finite = &pool_.cells[cell_of(cell.neighbors[3])];
    }
    return insphere_perturbed(corner(*finite, 0), corner(*finite, 1), corner(*finite, 2),
                              corner(*finite, 3), p()) == Sign::positive;
  }

  IdVector<VertexId, Point> points_;
  CellPool pool_;
  DelaunayCounters counters_;
};

TEST(ConflictSearch, AgreesWithThePredicatesOnHardPoints) {
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    SCOPED_TRACE(f);
    NearDegenerate random(11);
    for (int i = 0; i < 500; ++i) {
      const std::array<Point, 5> five = random.points(static_cast<Family>(f));
      if (!all_different(five)) continue;
      if (orient3d(five[0], five[1], five[2], five[3]) == Sign::zero) continue;
      FiveCells(five).search();
    }
  }
}

// The fifth point moves through the sphere of the others in steps as small as the error of the
// determinant, so that its value lies on both sides of the bound, and of zero.
TEST(ConflictSearch, AgreesWithThePredicatesAroundTheBoundOfInsphere) {
  NearDegenerate random(12);
  std::size_t left_open = 0;
  std::size_t decided = 0;
  for (int i = 0; i < 100; ++i) {
    std::array<Point, 5> five = random.points(Family::cospherical);
    const Point on_sphere = five[4];
    for (int step = -20; step <= 20; ++step) {
      five[4] = (1 + step * random.uniform(0, 1e4) * 0x1p-53) * on_sphere;
      FiveCells cells(five);
      cells.search();
      ++(cells.counters().wide_inspheres > 0 ? left_open : decided);
    }
  }
  EXPECT_GT(left_open, 400U);
  EXPECT_GT(decided, 400U);
}

// Five integer points on a sphere of radius 7 * 2^exponent, the last moved by `off`.
std::array<Point, 5> points_on_large_sphere(int exponent, double off) {
  std::array<Point, 5> five = {Point{2, 3, 6}, {-6, 2, 3}, {3, -6, 2}, {-2, -3, -6}, {6, 3, -2}};
  const Vec3 to_odd{1, 0, 0};  // so that they lie on no coarser grid
  for (Point& p : five) p = std::ldexp(1, exponent) * p + to_odd;
  five[4].x += off;
  return five;
}

// What doubles cannot tell pairs of them can; that it is a tie, too, if the sphere is not too large
// in units of the grid.
TEST(ConflictSearch, AgreesWithThePredicatesOnLargeSpheresOfIntegers) {
  for (int exponent = 1; exponent <= 40; ++exponent) {
    SCOPED_TRACE(exponent);
    FiveCells tie(points_on_large_sphere(exponent, 0));
    tie.search();
    if (exponent <= 12) {
      EXPECT_GT(tie.counters().perturbed_inspheres, 0U);
      EXPECT_EQ(tie.counters().exact_inspheres, 0U);
    } else if (exponent >= 15) {
      EXPECT_EQ(tie.counters().perturbed_inspheres, 0U);
      EXPECT_GT(tie.counters().exact_inspheres, 0U);
    }
    for (const double off : {-1.0, 1.0}) {
      FiveCells near(points_on_large_sphere(exponent, off));
      near.search();
      EXPECT_EQ(near.counters().perturbed_inspheres, 0U);
      EXPECT_EQ(near.counters().exact_inspheres, 0U);
    }
  }
}

// In units so large, or so small, that powers of them leave the range of doubles.
TEST(ConflictSearch, AgreesWithThePredicatesInExtremeUnits) {
  for (const int unit : {-120, -90, -81, -79, 79, 81, 86, 90, 99}) {
    SCOPED_TRACE(unit);
    for (const int exponent : {6, 12, 14}) {
      for (const double off : {-5000.0, -1.0, 0.0, 1.0, 5000.0}) {
        std::array<Point, 5> five = points_on_large_sphere(exponent, off);
        for (Point& p : five) p = std::ldexp(1, unit) * p;
        FiveCells(five).search();
      }
    }
  }
}

// The same for the sides of the walk: the fifth point moves through the plane of a facet.
TEST(ConflictSearch, AgreesWithThePredicatesAroundTheBoundOfOrient3d) {
  NearDegenerate random(13);
  for (int i = 0; i < 100; ++i) {
    std::array<Point, 5> five = random.points(Family::random);
    const Point in_facet = five[0] + random.uniform(0.1, 0.4) * (five[1] - five[0]) +
                           random.uniform(0.1, 0.4) * (five[2] - five[0]);
    for (int step = -20; step <= 20; ++step) {
      five[4] = in_facet + (step * random.uniform(0, 20) * 0x1p-53) * (five[3] - five[0]);
      FiveCells(five).search();
    }
  }
}

// Not only the same triangulation, but the same cells in the same places.
TEST(ConflictSearch, IsTheSameOnEveryInstructionSet) {
  const std::vector<std::vector<Point>> sets = {gallery::uniform_cube(2000), gallery::sphere(500),
                                                gallery::integer_grid(8),
                                                gallery::displaced_torus(2000)};
  for (const std::vector<Point>& points : sets) {
    const DelaunayResult expected = delaunay(points);
    for (std::int64_t left = instruction_sets(); left != 0; left &= left - 1) {
      const std::int64_t target = left & -left;
      SCOPED_TRACE(hwy::TargetName(target));
      chosen_instruction_set().Update(target);
      const DelaunayResult actual = delaunay(points);
      EXPECT_EQ(actual.triangulation.cell_records(), expected.triangulation.cell_records());
      EXPECT_EQ(actual.counters.walk_steps, expected.counters.walk_steps);
      EXPECT_EQ(actual.counters.wide_inspheres, expected.counters.wide_inspheres);
      EXPECT_EQ(actual.counters.exact_inspheres, expected.counters.exact_inspheres);
    }
    chosen_instruction_set().Update(instruction_sets());
  }
}

}  // namespace
}  // namespace cocoon
