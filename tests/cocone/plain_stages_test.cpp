// Every stage of Tight Cocone gives what the plain implementation gives (ref/cgal_stages.h): the
// two share no code, and no numbers but those of the points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "cocone/reconstruct.h"
#include "io/point_file.h"
#include "ref/cgal_stages.h"
#include "ref/cgal_surface.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages_by_point.h"

namespace cocoon {
namespace {

using ref::TightStages;

// As published: radius of the cocone. The other one is that of the defaults, without what is ours:
// clean-up and deferred seeds.
ReconstructOptions options_of(bool tangent_plane, double rho) {
  ReconstructOptions options;
  options.mode = tangent_plane ? Mode::robust : Mode::paper;
  options.boundary.rho = rho;
  options.peel.deferred_seeding = false;
  options.clean_up.enabled = false;
  return options;
}

void expect_equal_flags(const TightStages::Flags& ours, const TightStages::Flags& plain,
                        const char* what) {
  std::size_t only_ours = 0;
  std::size_t only_plain = 0;
  for (const PointId p : ours.ids()) {
    only_ours += ours[p] > plain[p];
    only_plain += ours[p] < plain[p];
  }
  EXPECT_EQ(only_ours, 0U) << what;
  EXPECT_EQ(only_plain, 0U) << what;
}

void expect_equal_triangles(const TightStages::Triangles& ours, const TightStages::Triangles& plain,
                            const char* what) {
  TightStages::Triangles both;
  std::set_intersection(ours.begin(), ours.end(), plain.begin(), plain.end(),
                        std::back_inserter(both));
  EXPECT_EQ(ours.size() - both.size(), 0U) << what;
  EXPECT_EQ(plain.size() - both.size(), 0U) << what;
}

void expect_equal_poles(const TightStages& ours, const TightStages& plain) {
  for (const PointId p : ours.normals.ids()) {
    ASSERT_GT(std::abs(dot(ours.normals[p], plain.normals[p])), 1 - 1e-12) << p.value;
    ASSERT_NEAR(ours.heights[p], plain.heights[p], 1e-8 * ours.heights[p]) << p.value;
  }
}

void expect_equal_cells(const TightStages& ours, const TightStages& plain) {
  ASSERT_EQ(ours.cells.size(), plain.cells.size());
  std::size_t marked = 0;
  std::size_t peeled = 0;
  std::size_t reached = 0;
  for (std::size_t c = 0; c < ours.cells.size(); ++c) {
    ASSERT_EQ(ours.cells[c].corners, plain.cells[c].corners);
    marked += ours.cells[c].marked != plain.cells[c].marked;
    peeled += ours.cells[c].peeled != plain.cells[c].peeled;
    reached += ours.cells[c].reached != plain.cells[c].reached;
  }
  EXPECT_EQ(marked, 0U);
  EXPECT_EQ(peeled, 0U);
  EXPECT_EQ(reached, 0U);
}

void expect_equal_stages(const TightStages& ours, const TightStages& plain) {
  expect_equal_poles(ours, plain);
  expect_equal_flags(ours.boundary, plain.boundary, "boundary samples");
  expect_equal_triangles(ours.candidates, plain.candidates, "candidates");
  expect_equal_flags(ours.umbrella, plain.umbrella, "umbrellas");
  expect_equal_triangles(ours.left, plain.left, "left by pruning");
  expect_equal_triangles(ours.surface, plain.surface, "surface");
  expect_equal_flags(ours.good, plain.good, "good vertices");
  expect_equal_flags(ours.visited, plain.visited, "vertices visited by the marking");
  expect_equal_cells(ours, plain);
  expect_equal_triangles(ours.triangles, plain.triangles, "watertight surface");
}

TightStages::Triangles sorted(TightStages::Triangles triangles) {
  for (auto& triangle : triangles) std::sort(triangle.begin(), triangle.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TightStages::Triangles triangles_of(const ReconstructResult& result) {
  TightStages::Triangles triangles;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto& point_of = result.point_of_vertex;
    triangles.push_back({point_of[a], point_of[b], point_of[c]});
  }
  return sorted(std::move(triangles));
}

// What the tests have seen in all sets together: each step of a stage must have had something to
// do.
struct Seen {
  std::size_t degenerate_poles = 0;
  std::size_t boundary_samples = 0;
  std::size_t without_umbrella = 0;
  std::size_t pruned = 0;
  std::size_t dropped = 0;
  std::size_t walks = 0;
  std::size_t back_contacts = 0;
  std::size_t demoted = 0;
  std::size_t unvisited = 0;
  std::size_t conflicts = 0;
  std::size_t poor_cells = 0;
  std::size_t nothing = 0;  // sets without an interior sample

  void add(const ReconstructResult& tight) {
    const ReconstructCounters& counters = tight.counters;
    degenerate_poles += counters.degenerate_poles;
    boundary_samples += counters.boundary_samples;
    without_umbrella += tight.vertices - counters.umbrellas;
    pruned += counters.pruned;
    dropped += counters.candidates - counters.pruned - counters.surface_triangles;
    walks += counters.surface_walks;
    back_contacts += counters.back_contacts;
    demoted += counters.demoted_vertices;
    unvisited += counters.unvisited_vertices;
    conflicts += counters.marking_conflicts;
    poor_cells += counters.poor_cells;
    nothing += tight.status == SurfaceStatus::no_surface ? 1U : 0U;
  }
};

void expect_equal(const char* name, const std::vector<Point>& points, double rho, Seen& seen) {
  for (const bool tangent_plane : {false, true}) {
    SCOPED_TRACE(std::string(name) + (tangent_plane ? ", tangent plane" : ", cocone") + ", rho " +
                 std::to_string(rho));
    const ReconstructOptions options = options_of(tangent_plane, rho);
    const ref::CgalCoconeOptions plain_options{.rho = rho, .tangent_plane_radius = tangent_plane};
    const TightStages ours = StagesByPoint(points, options).run();
    const TightStages plain = ref::cgal_stages(points, plain_options);
    expect_equal_stages(ours, plain);
    const ReconstructResult tight = reconstruct_tight(points, options);
    expect_equal_triangles(triangles_of(tight), plain.triangles, "reconstruct_tight");
    expect_equal_triangles(triangles_of(reconstruct_cocone(points, options)), plain.surface,
                           "reconstruct_cocone");
    expect_equal_triangles(sorted(ref::cgal_tight_surface(points, plain_options).triangles),
                           plain.triangles, "cgal_tight_surface");
    expect_equal_triangles(sorted(ref::cgal_open_surface(points, plain_options).triangles),
                           plain.surface, "cgal_open_surface");
    seen.add(tight);
  }
}

std::vector<Point> flattened(std::vector<Point> points, double factor) {
  for (Point& p : points) p.z *= factor;
  return points;
}

// A jittered grid between two planes closer than the spacing: hull normals cancel at its rim.
std::vector<Point> thin_layer() {
  std::vector<Point> points = shapes::dome_patch(25, 0.4, 3);
  const std::vector<Point> heights = shapes::random_cube(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z = 0.0002 * heights[i].z;
  return points;
}

// Stray points around a sphere: only the second pass of the peel takes them away, with it.
std::vector<Point> sphere_among_outliers() {
  std::vector<Point> outliers = shapes::random_cube(60, 5);
  for (Point& p : outliers) p = 8 * (p - Point{0.5, 0.5, 0.5});
  return shapes::joined(shapes::sphere(1200, 3), outliers);
}

constexpr double closed = 1 / 1.2;

TEST(PlainStages, AreOursOnCleanSamples) {
  Seen seen;
  expect_equal("sphere", shapes::sphere(1500, 1), closed, seen);
  expect_equal("ellipsoid", shapes::ellipsoid(1500, 2), closed, seen);
  expect_equal("random torus", shapes::random_torus(1500, 0.4, 7), closed, seen);
  expect_equal("torus", shapes::torus(60, 30, 0.4, 0.3, 3), closed, seen);
  expect_equal("sphere in sphere",
               shapes::joined(shapes::sphere(1200, 3), shapes::sphere(500, 4, 0.4)), closed, seen);
  expect_equal("two spheres",
               shapes::joined(shapes::sphere(800, 3), shapes::moved(shapes::sphere(800, 4), {3})),
               closed, seen);
  EXPECT_EQ(seen.boundary_samples, 0U);
  EXPECT_EQ(seen.conflicts, 0U);
  EXPECT_GT(seen.dropped, 500U);
  EXPECT_GT(seen.walks, 14U);
  EXPECT_GT(seen.unvisited, 900U) << "of the inner sphere";
}

// Noise of 1, 3 and 10 % of the size, and of 30 % of the spacing.
TEST(PlainStages, AreOursOnNoisySamples) {
  Seen seen;
  for (const std::uint64_t seed : {1U, 6U, 11U}) {
    for (const double noise : {0.01, 0.03, 0.1}) {
      expect_equal("sphere", shapes::noisy_sphere(1500, noise, seed), closed, seen);
    }
    expect_equal("a third of the spacing", shapes::noisy_sphere(3000, 0.015, seed), closed, seen);
    expect_equal("moebius strip", shapes::moebius_strip(120, 11, 0.3, seed), closed, seen);
  }
  EXPECT_GT(seen.boundary_samples, 10000U);
  EXPECT_GT(seen.without_umbrella, 10000U);
  EXPECT_GT(seen.pruned, 1000U);
  EXPECT_GT(seen.dropped, 10000U);
  EXPECT_GT(seen.walks, 25U);
  EXPECT_GT(seen.back_contacts, 100U);
  EXPECT_GT(seen.demoted, 100U);
  EXPECT_GT(seen.unvisited, 100U);
  EXPECT_GT(seen.conflicts, 100U);
  EXPECT_GT(seen.poor_cells, 1000U);
  EXPECT_GT(seen.nothing, 0U);
}

TEST(PlainStages, AreOursWhereTheSurfaceHasHoles) {
  Seen seen;
  for (const double rho : {closed, 0.3}) {
    expect_equal("cut sphere", shapes::cut_sphere(1000, 0.5, 9), rho, seen);
    expect_equal("half a sphere", shapes::cut_sphere(1000, 0, 9), rho, seen);
    expect_equal("dome", shapes::dome_patch(25, 0.5, 8), rho, seen);
    expect_equal("sheet", flattened(shapes::dome_patch(25, 0.4, 3), 0.02), rho, seen);
    expect_equal("thin layer", thin_layer(), rho, seen);
    expect_equal("outliers", sphere_among_outliers(), rho, seen);
  }
  for (const double rho : {0.13, 0.3, 0.5}) {
    expect_equal("random torus", shapes::random_torus(1500, 0.4, 7), rho, seen);
  }
  EXPECT_GT(seen.boundary_samples, 1000U);
  EXPECT_GT(seen.degenerate_poles, 4U);
  EXPECT_GT(seen.unvisited, 4000U) << "a sphere that outliers shield from the hull";
  EXPECT_GT(seen.poor_cells, 1000U);
}

// Neither has a surface: no sample is interior. Where rho makes some so it is rubble.
TEST(PlainStages, AreOursInARandomCube) {
  Seen seen;
  expect_equal("random cube", shapes::random_cube(500, 10), closed, seen);
  EXPECT_EQ(seen.nothing, 2U);
  for (const double rho : {1.5, 4.0}) {
    expect_equal("random cube", shapes::random_cube(1000, 2), rho, seen);
  }
  EXPECT_EQ(seen.nothing, 2U);
  EXPECT_GT(seen.pruned, 200U);
  EXPECT_GT(seen.back_contacts, 100U);
}

std::vector<Point> scan(const std::string& name) {
  std::vector<Point> points = read_points(COCOON_TEST_DATA "/" + name).points;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

TEST(PlainStages, AreOursOnScans) {
  Seen seen;
  expect_equal("kitten", scan("points/kitten.xyz"), closed, seen);
  expect_equal("half", scan("points/half.xyz"), 0.3, seen);
  expect_equal("poste_france", scan("poste_france.xyz"), closed, seen);
  EXPECT_GT(seen.boundary_samples, 100U);
  EXPECT_GT(seen.poor_cells, 30U);
}

// Cospherical, coplanar and collinear points, whose cells may be as flat as rounding allows.
TEST(PlainStages, AreOursOnGrids) {
  Seen seen;
  expect_equal("cube", shapes::cube_grid(9), closed, seen);
  expect_equal("cube", shapes::cube_grid(20), closed, seen);
  expect_equal("plate", shapes::plate(20, 2), closed, seen);
  expect_equal("latitude sphere", shapes::latitude_sphere(30, 48), closed, seen);
  expect_equal("sheet", flattened(shapes::dome_patch(12, 0, 1), 0.05), closed, seen);
  EXPECT_GT(seen.boundary_samples, 500U);
  EXPECT_GT(seen.poor_cells, 50U);
}

// How much of the stages differs, and in how many choices the plain way must follow ours at ties
// within rounding so that nothing does.
struct Differences {
  std::size_t poles = 0;
  std::size_t candidates = 0;
  std::size_t reached = 0;
  std::size_t ties = 0;
};

Differences expect_equal_but_for_ties(const std::vector<Point>& points, double rho) {
  const ref::CgalCoconeOptions plain_options{.rho = rho};
  const TightStages ours = StagesByPoint(points, options_of(true, rho)).run();
  const TightStages plain = ref::cgal_stages(points, plain_options);
  Differences found;
  for (const PointId p : ours.normals.ids()) {
    found.poles += std::abs(dot(ours.normals[p], plain.normals[p])) < 1 - 1e-12;
  }
  TightStages::Triangles differ;
  std::set_symmetric_difference(ours.candidates.begin(), ours.candidates.end(),
                                plain.candidates.begin(), plain.candidates.end(),
                                std::back_inserter(differ));
  found.candidates = differ.size();
  for (std::size_t c = 0; c < ours.cells.size(); ++c) {
    found.reached += ours.cells[c].reached != plain.cells[c].reached;
  }
  EXPECT_EQ(plain.ties, 0U);
  const TightStages at_ties = ref::cgal_stages(points, plain_options, &ours);
  expect_equal_stages(ours, at_ties);
  found.ties = at_ties.ties;
  return found;
}

// The grid points on the surface of a block with a groove.
std::vector<Point> grooved_block(int steps) {
  const int wall = steps / 3;
  std::vector<Point> points;
  const auto is_solid = [&](int x, int y, int z) {
    const bool inside = std::min({x, y, z}) >= 0 && std::max({x, y, z}) < steps;
    return inside && (x < wall || x >= steps - wall || y < wall);
  };
  for (int x = 0; x <= steps; ++x) {
    for (int y = 0; y <= steps; ++y) {
      for (int z = 0; z <= steps; ++z) {
        int solid = 0;
        for (int i = 0; i < 8; ++i) solid += is_solid(x - (i & 1), y - (i >> 1 & 1), z - (i >> 2));
        if (solid > 0 && solid < 8) points.push_back({double(x), double(y), double(z)});
      }
    }
  }
  return points;
}

// Equally far Voronoi vertices and facets of equal size, of which one is chosen by the last bit of
// what was computed. Nothing else differs.
TEST(PlainStages, DifferFromOursByTiesAlone) {
  const Differences torus = expect_equal_but_for_ties(shapes::torus(16, 12, 0.4, 0, 1), closed);
  EXPECT_GT(torus.poles, 0U);
  EXPECT_LE(torus.poles, torus.ties);
  EXPECT_LT(torus.poles, 16U) << "of 192";
  EXPECT_LT(torus.candidates, 16U) << "of 478";
  const Differences block = expect_equal_but_for_ties(grooved_block(6), closed);
  EXPECT_GT(block.poles, 0U);
  EXPECT_GT(block.ties, block.poles) << "stop facets, too";
  EXPECT_LT(block.poles, 16U) << "of 250";
  EXPECT_EQ(block.candidates, 0U);
  EXPECT_LT(block.reached, 64U);
  const std::vector<Point> sphere = shapes::latitude_sphere(17, 32);
  std::vector<Point> inner = sphere;
  for (Point& p : inner) p = 0.9 * p;
  const Differences shells = expect_equal_but_for_ties(shapes::joined(sphere, inner), closed);
  EXPECT_EQ(shells.poles, 0U);
  EXPECT_GT(shells.reached, 0U);
  EXPECT_LT(shells.reached, 64U);
}

}  // namespace
}  // namespace cocoon
