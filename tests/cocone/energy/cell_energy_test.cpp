#include "cocone/energy/cell_energy.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "cocone/clean_up/surface_flaws.h"
#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

TEST(CellEnergy, ChangeIsTheDifferenceOfTheWholeEnergies) {
  for (const double bias : {0.1, 0.5, 0.8, 0.97}) {
    for (const auto& points : {shapes::random_cube(25, 3), gallery::integer_grid(3), ball(4),
                               shapes::random_torus(40, 0.4, 2)}) {
      Labeling labeling(points, 7, bias);
      for (const VertexId v : labeling.stages.triangulation.vertices()) {
        if (labeling.parts(v) != 2) labeling.energy.doubt(v);
      }
      labeling.energy.know_flawless_elsewhere();
      Random random(5);
      const std::size_t count = labeling.stages.triangulation.num_finite_cells();
      for (int round = 0; round < 40; ++round) {
        std::set<CellId> chosen;
        const std::size_t size = 1 + static_cast<std::size_t>(random.uniform() * 4);
        CellId c(static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
        while (chosen.size() < size && !labeling.stages.triangulation.is_infinite(c)) {
          chosen.insert(c);
          c = labeling.stages.triangulation.neighbor(c, static_cast<int>(random.uniform() * 4));
        }
        const std::vector<CellId> cells(chosen.begin(), chosen.end());
        const Energy before = labeling.total();
        const Energy change = labeling.energy.change(cells);
        EXPECT_EQ(labeling.total(), before);
        const Energy limit = to_energy(-20);
        const Energy limited = labeling.energy.change(cells, limit);
        EXPECT_TRUE(limited == change || (limited > limit && change > limit));
        labeling.energy.flip(cells);
        EXPECT_EQ(labeling.total() - before, change) << cells.size() << " cells, bias " << bias;
      }
    }
  }
}

// The bounds of pairs and of single cells are that of sets; where no vertex matters they are exact.
TEST(CellEnergy, NoChangeIsLessThanItsBound) {
  std::size_t exact = 0;
  for (const double bias : {0.1, 0.5, 0.97}) {
    for (const auto& points : {shapes::random_cube(25, 3), gallery::integer_grid(3), ball(4)}) {
      Labeling labeling(points, 8, bias);
      CellEnergy& energy = labeling.energy;
      const Triangulation& t = labeling.stages.triangulation;
      for (const CellId c : t.finite_cells()) {
        EXPECT_EQ(energy.least_change(c), energy.least_change(std::array{c}));
        EXPECT_LE(energy.least_change(c), energy.change(std::array{c}));
        for (int i = 0; i < 4; ++i) {
          const CellId d = t.neighbor(c, i);
          if (t.is_infinite(d) || labeling.out[c] != labeling.out[d]) continue;
          const Energy least = CellEnergy::BoundsOfCell(energy, c).with(i);
          EXPECT_EQ(least, energy.least_change(std::array{c, d}));
          EXPECT_LE(least, energy.change(std::array{c, d}));
          exact += least == energy.change(std::array{c, d}) ? 1U : 0U;
        }
        energy.flip(std::array{c});  // what is remembered must be told anew around it
      }
      for (const VertexId v : t.vertices()) {
        for (const std::vector<CellId>& part : energy.parts_of_star(v)) {
          if (std::any_of(part.begin(), part.end(), [&](CellId c) { return t.is_infinite(c); })) {
            continue;
          }
          const Energy change = energy.change(part);
          EXPECT_LE(energy.least_change(part), change);
          EXPECT_LE(energy.least_change(part, to_energy(-20)), std::max(change, to_energy(-20)));
        }
      }
    }
  }
  EXPECT_GT(exact, 0U);
}

TEST(CellEnergy, PartsOfStarsAndFlawsAreThoseOfThePlainSearch) {
  for (const double bias : {0.02, 0.3, 0.9}) {
    for (const auto& points : {shapes::random_cube(60, 3), gallery::integer_grid(4), ball(4)}) {
      Labeling labeling(points, 9, bias);
      const Triangulation& t = labeling.stages.triangulation;
      CellMarks marks;
      marks.good = VertexSet(t.num_vertices(), 0);
      StarCache region_stars(t);
      SpacingCache spacings(t, region_stars);
      const SurfaceFlaws flaws = find_surface_flaws(
          t, find_doubtful_region(t, marks, region_stars, spacings, t.num_cells(), 0),
          labeling.out);
      std::size_t unused = 0;
      std::size_t pinched = 0;
      for (const VertexId v : t.vertices()) {
        const std::size_t parts = labeling.parts(v);
        EXPECT_EQ(labeling.energy.parts_of_star(v).size(), parts);
        EXPECT_EQ(labeling.energy.extra_fans(v), parts < 2 ? 0 : parts - 2);
        EXPECT_EQ(std::count(flaws.unused.begin(), flaws.unused.end(), v), parts == 1 ? 1 : 0);
        EXPECT_EQ(std::count(flaws.pinched.begin(), flaws.pinched.end(), v), parts > 2 ? 1 : 0);
        unused += parts == 1 ? 1U : 0U;
        pinched += parts > 2 ? 1U : 0U;
      }
      EXPECT_EQ(flaws.unused.size(), unused);
      EXPECT_EQ(flaws.pinched.size(), pinched);
    }
  }
}

// Two clumps of samples far apart: what crosses the gap costs more, by the length of its longest
// edge in spacings.
TEST(CellEnergy, LongFacetsCostMore) {
  std::vector<Point> points = shapes::random_cube(20, 3);
  points = shapes::joined(points, shapes::moved(points, {30, 0, 0}));
  Labeling labeling(points);
  const Triangulation& t = labeling.stages.triangulation;
  CleanUpOptions without;
  without.stretch_cost = 0;
  CellEnergy plain(t, labeling.cosines, labeling.stars, labeling.spacings, labeling.marks, without,
                   labeling.out);
  std::size_t stretched = 0;
  for (const CellId c : t.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      const Triangle v = t.facet_vertices(facet_id(c, i));
      double length = 0;
      double spacing = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        length = std::max(length, norm(t.point(v[k]) - t.point(v[(k + 1) % 3])));
        spacing = std::max(spacing, labeling.spacings.of(v[k]));
      }
      const double expected = 3 * std::max(0.0, 1 - 6 * spacing / length);
      const Energy more =
          labeling.energy.facet_cost(facet_id(c, i)) - plain.facet_cost(facet_id(c, i));
      EXPECT_NEAR(static_cast<double>(more), 0x1p+20 * expected, 1.0);
      stretched += expected > 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(stretched, 20U);
}

TEST(CellEnergy, CostsHaveALimit) {
  EXPECT_EQ(to_energy(1.5), Energy{3} << 19);
  EXPECT_EQ(to_energy(-1e6), -1000000 * (Energy{1} << 20));
  for (const double cost : {2e6, 1e13, 1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(to_energy(cost), Energy{1} << 40);
    EXPECT_EQ(to_energy(-cost), -(Energy{1} << 40));
  }
  EXPECT_EQ(to_energy(std::numeric_limits<double>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace cocoon
