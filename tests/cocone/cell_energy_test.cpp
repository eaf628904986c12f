#include "cocone/cell_energy.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>

#include "cocone/surface_flaws.h"
#include "geom/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

std::vector<Point> cube(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < count) {
    points.push_back({random.uniform(), random.uniform(), random.uniform()});
  }
  return points;
}

std::vector<Point> lattice(int side) {
  std::vector<Point> points;
  for (int i = 0; i < side * side * side; ++i) {
    points.push_back({double(i % side), double(i / side % side), double(i / side / side)});
  }
  return points;
}

// A center with far more than 64 cells around it.
std::vector<Point> ball(std::uint64_t seed) {
  std::vector<Point> points = shapes::sphere(60, seed);
  points.push_back({0, 0, 0});
  return points;
}

struct Labeling {
  explicit Labeling(const std::vector<Point>& points, std::uint64_t seed = 1, double bias = 0.5)
      : stages(points),
        cosines(stages.triangulation),
        stars(stages.triangulation),
        labels(stages.triangulation.num_cells(), CellLabel::out),
        out(stages.triangulation.num_cells(), 1),
        energy(stages.triangulation, cosines, stars, labels, options, out) {
    Random random(seed);
    for (const CellId c : stages.triangulation.finite_cells()) {
      out[c] = random.uniform() < bias ? 1 : 0;
      labels[c] = random.uniform() < 0.5 ? CellLabel::out : CellLabel::in;
      energy.set_preference(c, to_energy(random.uniform() - 0.5));
    }
    for (const VertexId v : stages.triangulation.vertices()) {
      if (random.uniform() < 0.7) energy.want(v);
    }
  }

  // The parts of a star by the plainest means: labels that spread until nothing changes.
  std::size_t parts(VertexId v) const {
    const std::span<const CellId> star = stages.stars.star(v);
    std::map<CellId, CellId> root;
    for (const CellId c : star) root[c] = c;
    for (bool changed = true; changed;) {
      changed = false;
      for (const CellId c : star) {
        for (int i = 0; i < 4; ++i) {
          const CellId d = stages.triangulation.neighbor(c, i);
          if (root.count(d) == 0 || out[c] != out[d] || stages.triangulation.vertex(c, i) == v) {
            continue;
          }
          changed = changed || root[c] != root[d];
          root[c] = root[d] = std::min(root[c], root[d]);
        }
      }
    }
    std::set<CellId> roots;
    for (const auto& [c, r] : root) roots.insert(r);
    return roots.size();
  }

  // The whole energy, term by term from its definition.
  Energy total() {
    const Triangulation& t = stages.triangulation;
    Energy sum = 0;
    std::ptrdiff_t euler = 0;
    std::map<std::pair<VertexId, VertexId>, std::size_t> facets_at_edge;
    for (const CellId c : t.finite_cells()) {
      if (out[c] != 0) {
        sum += energy.preference(c);
        continue;
      }
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (out[t.neighbor(c, i)] == 0) continue;
        sum += energy.facet_cost(f);
        ++euler;
        std::array<VertexId, 3> v = t.facet_vertices(f);
        std::sort(v.begin(), v.end());
        for (const auto& edge : {std::pair(v[0], v[1]), {v[0], v[2]}, {v[1], v[2]}}) {
          ++facets_at_edge[edge];
        }
      }
    }
    for (const auto& [edge, facets] : facets_at_edge) {
      --euler;
      sum += to_energy(options.defect_cost) * static_cast<Energy>(facets / 2 - 1);
    }
    for (const VertexId v : t.vertices()) {
      const std::size_t fans = parts(v);
      if (fans == 1) {
        sum += energy.is_wanted(v) ? to_energy(options.unused_cost) : 0;
        continue;
      }
      ++euler;
      sum += to_energy(options.defect_cost) * static_cast<Energy>(fans - 2);
      const bool idle = is_idle(t, stages.stars.star(v), out, v, options.idle);
      sum += idle ? to_energy(options.idle_cost) : 0;
    }
    return sum - to_energy(options.handle_cost / 2) * static_cast<Energy>(euler);
  }

  CleanUpOptions options;
  Stages stages;
  BallCosines cosines;
  StarCache stars;
  IdVector<CellId, CellLabel> labels;
  IdVector<CellId, std::uint8_t> out;
  CellEnergy energy;
};

TEST(CellEnergy, ChangeIsTheDifferenceOfTheWholeEnergies) {
  for (const double bias : {0.1, 0.5, 0.8, 0.97}) {
    for (const auto& points :
         {cube(25, 3), lattice(3), ball(4), shapes::random_torus(40, 0.4, 2)}) {
      Labeling labeling(points, 7, bias);
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

TEST(CellEnergy, PartsOfStarsAndFlawsAreThoseOfThePlainSearch) {
  for (const double bias : {0.02, 0.3, 0.9}) {
    for (const auto& points : {cube(60, 3), lattice(4), ball(4)}) {
      Labeling labeling(points, 9, bias);
      const Triangulation& t = labeling.stages.triangulation;
      CellMarks marks;
      marks.good = VertexSet(t.num_vertices(), 0);
      const SurfaceFlaws flaws =
          find_surface_flaws(t, find_doubtful_region(t, marks), labeling.out);
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

// A regular tetrahedron: the ball's tangent plane at a facet's circle leans by acos(1/3) inward.
TEST(BallCosines, OfARegularTetrahedron) {
  Stages stages({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  BallCosines cosines(stages.triangulation);
  for (int i = 0; i < 4; ++i) {
    const FacetId f = facet_id(CellId(0), i);
    EXPECT_NEAR(cosines.of(f), 1.0 / 3, 1e-15);
    EXPECT_EQ(cosines.of(stages.triangulation.mirror(f)), 1);
    EXPECT_NEAR(cosines.contact(f), -1.0 / 3, 1e-15);
    EXPECT_EQ(cosines.contact(f), cosines.contact(stages.triangulation.mirror(f)));
  }
}

TEST(BallCosines, EqualBallsMeetAtNoAngle) {
  Stages stages(lattice(2));  // one ball through all eight
  BallCosines cosines(stages.triangulation);
  for (const CellId c : stages.triangulation.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      if (stages.triangulation.is_infinite(stages.triangulation.neighbor(c, i))) continue;
      EXPECT_NEAR(cosines.contact(facet_id(c, i)), 1, 1e-12);
    }
  }
}

// It has all stars listed once many have been asked for; nothing else changes.
TEST(StarCache, TellsTheStarsOfVertexStars) {
  const Triangulation triangulation = delaunay(cube(3000, 8)).triangulation;
  const VertexStars stars = vertex_stars(triangulation);
  StarCache cache(triangulation);
  const std::span<const CellId> first = cache.star(VertexId(0));
  for (const VertexId v : triangulation.vertices()) {
    const std::span<const CellId> star = cache.star(v);
    EXPECT_TRUE(std::equal(star.begin(), star.end(), stars.star(v).begin(), stars.star(v).end()));
  }
  const std::span<const CellId> again = stars.star(VertexId(0));
  EXPECT_TRUE(std::equal(first.begin(), first.end(), again.begin(), again.end()));
}

}  // namespace
}  // namespace cocoon
