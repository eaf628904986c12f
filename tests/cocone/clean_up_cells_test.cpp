#include "cocone/clean_up_cells.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <string_view>

#include "cocone/clean_up/handle_loops.h"
#include "cocone/mark_cells.h"
#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "geom/execution.h"
#include "geom/mesh/dense_samples.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/surface_distance.h"
#include "io/mesh_file.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

std::vector<Point> vertices_of_model(const std::string& name) {
  const TriangleMesh mesh = read_mesh(std::string(COCOON_TEST_DATA) + "/models/" + name);
  return {mesh.points.begin(), mesh.points.end()};
}

TEST(CleanUpCells, CleanDataIsNotTouched) {
  for (const auto& points : {shapes::sphere(2000, 1), shapes::random_torus(2500, 0.4, 2),
                             shapes::latitude_sphere(15, 24)}) {
    const CleanUpCounters counters = reconstruct_tight(points).counters.clean_up;
    EXPECT_EQ(counters.undecided_cells, 0U);
    EXPECT_EQ(counters.relabeled_cells, 0U);
    EXPECT_EQ(counters.moves, 0U);
    EXPECT_EQ(counters.changed_cells, 0U);
  }
}

TEST(CleanUpCells, PaperModeAndDisabledLeaveThePeelAsItIs) {
  const std::vector<Point> points = shapes::noisy_sphere(2000, 0.03, 5);
  ReconstructOptions off;
  off.clean_up.enabled = false;
  EXPECT_EQ(reconstruct_tight(points, off).counters.clean_up.undecided_cells, 0U);
  const ReconstructResult paper = reconstruct_tight(points, {.mode = Mode::paper});
  EXPECT_EQ(paper.counters.clean_up.undecided_cells, 0U);
  EXPECT_GT(reconstruct_tight(points).counters.clean_up.undecided_cells, 0U);
}

// Noise makes non-manifold edges and leaves samples out; the clean-up says what it did about it.
TEST(CleanUpCells, NoiseLosesItsDefects) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.02, 6);
  const ReconstructResult result = reconstruct_tight(points);
  const MeshReport report = mesh_check(result.mesh);
  const CleanUpCounters& counters = result.counters.clean_up;
  EXPECT_TRUE(report.balanced);
  EXPECT_GT(counters.defects_before, 0U);
  EXPECT_LT(10 * counters.defects_after, counters.defects_before);
  EXPECT_LE(counters.unused_after, counters.unused_before);
  EXPECT_EQ(counters.unused_after, result.unused_points);
}

// What single moves cannot mend, since each of them breaks something else, several together can.
TEST(CleanUpCells, CompoundMovesMendWhatSingleMovesLeave) {
  std::size_t flaws = 0;
  std::size_t flaws_of_single_moves = 0;
  ReconstructOptions single;
  single.clean_up.max_rise = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Point> points = shapes::noisy_sphere(1500, 0.06, seed);
    const CleanUpCounters counters = reconstruct_tight(points).counters.clean_up;
    flaws += counters.defects_after + counters.unused_after;
    EXPECT_GE(counters.compound_cells, 2 * counters.compound_moves);
    const CleanUpCounters of_single = reconstruct_tight(points, single).counters.clean_up;
    flaws_of_single_moves += of_single.defects_after + of_single.unused_after;
    EXPECT_EQ(of_single.compound_moves, 0U);
  }
  EXPECT_LT(flaws, flaws_of_single_moves);
}

std::size_t longer_than(const TriangleMesh& mesh, double length) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const Point& a = mesh.points[t[0]];
        const Point& b = mesh.points[t[1]];
        const Point& c = mesh.points[t[2]];
        return std::max({norm(a - b), norm(b - c), norm(c - a)}) > length;
      }));
}

// In a noisy layer (here 46 % of the spacing) many samples are not on the surface. Slivers from
// there to another body would put them on it.
TEST(CleanUpCells, FewSliversCrossEmptySpace) {
  const auto slivers = [&](double stretch_cost) {
    ReconstructOptions options;
    options.clean_up.stretch_cost = stretch_cost;
    options.clean_up.near_surface = 0;  // which bars some of them, too
    std::size_t count = 0;
    for (const std::uint64_t seed : {6, 8, 10, 12, 14, 16, 18, 20}) {
      const std::vector<Point> points =
          shapes::joined(shapes::noisy_sphere(3000, 0.03, seed),
                         shapes::moved(shapes::noisy_sphere(3000, 0.03, seed + 1), {3, 0.1, 0.2}));
      count += longer_than(reconstruct_tight(points, options).mesh, 1);  // 15 spacings
    }
    return count;
  };
  EXPECT_GT(2 * slivers(0), 3 * slivers(CleanUpOptions().stretch_cost));
}

struct Known {
  const char* file;
  std::ptrdiff_t euler;
};

// Meshes whose vertices are too few for the theory's guarantee.
TEST(CleanUpCells, UndersampledModelsGetTheirOwnTopology) {
  for (const Known& known : {Known{"elephant.off", -4}, Known{"anchor_dense.off", -6}}) {
    const std::vector<Point> points = vertices_of_model(known.file);
    const ReconstructResult result = reconstruct_tight(points);
    const MeshReport report = mesh_check(result.mesh);
    EXPECT_TRUE(report.is_closed_manifold()) << known.file;
    EXPECT_EQ(report.euler, known.euler) << known.file;
    EXPECT_EQ(report.components, 1U) << known.file;
    EXPECT_EQ(result.unused_points, 0U) << known.file;
    ReconstructOptions off;
    off.clean_up.enabled = false;
    EXPECT_FALSE(mesh_check(reconstruct_tight(points, off).mesh).is_closed_manifold())
        << known.file;
  }
}

// A drilled plate whose faces have no samples but those on the rims of the holes: as faces that run
// over the holes, nobody would have sampled them there.
TEST(CleanUpCells, HolesSampledAtTheirRimsOnlyAreOpen) {
  const std::vector<Point> points = vertices_of_model("plate_holes.stl");
  const ReconstructResult result = reconstruct_tight(points);
  const MeshReport report = mesh_check(result.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.euler, -8);  // five holes
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(result.unused_points, 0U);
  EXPECT_EQ(result.counters.clean_up.clusters, 5U);
  EXPECT_GT(result.counters.clean_up.idle_before, 100U);
  EXPECT_EQ(result.counters.clean_up.idle_after, 0U);
  ReconstructOptions filled;
  filled.clean_up.idle_cost = 0;
  EXPECT_EQ(mesh_check(reconstruct_tight(points, filled).mesh).euler, 2);
}

// The plate in a position of its own, its coordinates rounded.
std::vector<Point> turned_plate(std::uint64_t seed, bool single_precision) {
  Random random(seed);
  const Vec3 u = random.on_unit_sphere();
  const Vec3 v = unit(cross(u, random.on_unit_sphere()));
  const Vec3 w = cross(u, v);
  std::vector<Point> points;
  for (const Point& p : vertices_of_model("plate_holes.stl")) {
    Point q{dot(u, p), dot(v, p), dot(w, p)};
    if (single_precision) {
      q = {double(static_cast<float>(q.x)), double(static_cast<float>(q.y)),
           double(static_cast<float>(q.z))};
    }
    points.push_back(q);
  }
  return points;
}

// The faces of a turned part are planes but for rounding, with flat cells on them and across the
// holes. In files, coordinates often have single precision.
TEST(CleanUpCells, FlatCellsAreLookedThrough) {
  for (std::uint64_t turn = 0; turn < 4; ++turn) {
    const std::vector<Point> points = turned_plate(turn + 3, turn % 2 != 0);
    const ReconstructResult result = reconstruct_tight(points);
    const MeshReport report = mesh_check(result.mesh);
    EXPECT_TRUE(report.is_closed_manifold());
    EXPECT_EQ(report.euler, -8);
    EXPECT_EQ(report.components, 1U);
    EXPECT_GT(result.counters.clean_up.flat_cells, 100U);
    ReconstructOptions blind;
    blind.clean_up.flat_ratio = 0;
    const ReconstructResult asked = reconstruct_tight(points, blind);
    EXPECT_NE(mesh_check(asked.mesh).euler, -8);
    EXPECT_EQ(asked.counters.clean_up.flat_cells, 0U);
  }
}

// A toothed ring with six holes: one has a ball so near those of the wall that loose clusters hold
// both, and closer ones part them.
TEST(CleanUpCells, HolesBesideWallsOpenByCloserClusters) {
  const std::vector<Point> points = vertices_of_model("fixed_top.ply");
  const ReconstructResult result = reconstruct_tight(points);
  const MeshReport report = mesh_check(result.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.euler, -12);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(result.unused_points, 0U);
  ReconstructOptions loose;
  loose.clean_up.deeper_cosine = loose.clean_up.deep_cosine;
  EXPECT_EQ(mesh_check(reconstruct_tight(points, loose).mesh).euler, -10);
}

// The underside of the ring is a plane but for the last digits of its coordinates: between dense
// samples of it flat cells lie more than a hundred deep.
TEST(CleanUpCells, OneLooksThroughPilesOfFlatCellsOfAnyHeight) {
  const TriangleMesh ring = read_mesh(std::string(COCOON_TEST_DATA) + "/models/fixed_top.ply");
  std::vector<Point> points = dense_samples(ring, {.spacing = 1.5});
  points.insert(points.end(), ring.points.begin(), ring.points.end());
  const MeshReport report = mesh_check(reconstruct_tight(points).mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.euler, -12);
}

// As the inside of a body would be; it is counted, whatever the order of the points.
TEST(CleanUpCells, ClustersThatAreTooLargeAreLeftAlone) {
  const std::vector<Point> points = vertices_of_model("plate_holes.stl");
  ReconstructOptions small;
  small.clean_up.most_cluster_cells = 0;
  const CleanUpCounters counters = reconstruct_tight(points, small).counters.clean_up;
  EXPECT_EQ(counters.clusters, 0U);
  EXPECT_GT(counters.large_clusters, 100U);
  EXPECT_EQ(counters.large_clusters, counters.idle_before);
  EXPECT_EQ(reconstruct_tight(points).counters.clean_up.large_clusters, 0U);
  const ReconstructResult other = reconstruct_tight(shapes::shuffled(points, 3), small);
  EXPECT_EQ(other.counters.clean_up.large_clusters, counters.large_clusters);
}

// Samples of no surface: where all cells are undecided, the peel has the last word, but a
// surface beside them is cleaned up.
TEST(CleanUpCells, VolumesAreLeftAlone) {
  const std::vector<Point> volume = gallery::uniform_cube(3000, 3);
  ReconstructOptions bounded;
  bounded.clean_up.most_clump_cells = 8000;
  const ReconstructResult left = reconstruct_tight(volume, bounded);
  EXPECT_EQ(left.counters.clean_up.undecided_cells, 0U);
  EXPECT_GT(left.counters.clean_up.left_cells, 5000U);
  EXPECT_EQ(left.counters.clean_up.changed_cells, 0U);
  ReconstructOptions off;
  off.clean_up.enabled = false;
  EXPECT_EQ(left.mesh.triangles.size(), reconstruct_tight(volume, off).mesh.triangles.size());
  EXPECT_GT(reconstruct_tight(volume).counters.clean_up.undecided_cells, 5000U);

  const std::vector<Point> noisy =
      shapes::moved(shapes::noisy_sphere(3000, 0.02, 6), {.x = 10, .y = 0, .z = 0});
  const ReconstructResult both = reconstruct_tight(shapes::joined(volume, noisy), bounded);
  EXPECT_GT(both.counters.clean_up.left_cells, 5000U);
  EXPECT_GT(both.counters.clean_up.undecided_cells, 100U);
  EXPECT_GT(both.counters.clean_up.defects_before, 0U);
  EXPECT_LT(4 * both.counters.clean_up.defects_after, both.counters.clean_up.defects_before);
  ReconstructOptions by_share = bounded;
  by_share.clean_up.most_clump_share = 1;
  EXPECT_EQ(reconstruct_tight(volume, by_share).counters.clean_up.left_cells, 0U);
}

// What is computed ahead, on all threads, is what would be computed when asked for.
TEST(CleanUpCells, SameResultForEveryNumberOfThreads) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.02, 6);
  const ReconstructResult one = reconstruct_tight(points);
  ASSERT_GT(one.counters.clean_up.moves, 0U);
  for (const int threads : {2, 5}) {
    const ReconstructResult several = reconstruct_tight(points, {}, {.threads = threads});
    EXPECT_EQ(several.mesh, one.mesh);
    EXPECT_EQ(several.counters.clean_up.moves, one.counters.clean_up.moves);
    EXPECT_EQ(several.counters.clean_up.relabeled_cells, one.counters.clean_up.relabeled_cells);
    EXPECT_EQ(several.counters.clean_up.idle_before, one.counters.clean_up.idle_before);
  }
}

// A tunnel or a neck of three samples' girth is closed where that costs little: each time the
// sphere has a handle less, and uses no fewer samples.
TEST(CleanUpCells, HandlesOfTheLeastGirthAreClosed) {
  std::size_t closed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Point> points = shapes::noisy_sphere(1500, 0.05, seed);
    ReconstructOptions options;
    const ReconstructResult with = reconstruct_tight(points, options);
    options.clean_up.most_handle_facets = 0;
    const ReconstructResult without = reconstruct_tight(points, options);
    EXPECT_EQ(without.counters.clean_up.closed_handles, 0U);
    const auto handles = static_cast<std::ptrdiff_t>(with.counters.clean_up.closed_handles);
    EXPECT_LE(with.unused_points, without.unused_points);
    if (without.counters.clean_up.defects_after != 0) continue;  // a path may lead over a contact
    EXPECT_EQ(mesh_check(with.mesh).euler, mesh_check(without.mesh).euler + 2 * handles);
    closed += with.counters.clean_up.closed_handles;
  }
  EXPECT_GE(closed, 3U);
}

// Each flip at a sample with many cells changes what all of them cost: such handles are left, and
// counted.
TEST(CleanUpCells, HandlesAtSamplesWithManyCellsAreLeft) {
  std::size_t left = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Point> points = shapes::noisy_sphere(1500, 0.05, seed);
    ReconstructOptions options;
    EXPECT_EQ(reconstruct_tight(points, options).counters.clean_up.large_handles, 0U);
    options.clean_up.most_closing_cells = 3;  // fewer than any three stars have
    const CleanUpCounters counters = reconstruct_tight(points, options).counters.clean_up;
    EXPECT_EQ(counters.closed_handles, 0U);
    left += counters.large_handles;
  }
  EXPECT_GE(left, 3U);
}

// As where a sample faces a densely sampled wall from afar: it is left, and counted.
TEST(CleanUpCells, SamplesWithVeryManyCellsAreLeft) {
  const std::vector<Point> points = shapes::noisy_sphere(1500, 0.05, 1);
  ReconstructOptions options;
  const CleanUpCounters moved = reconstruct_tight(points, options).counters.clean_up;
  EXPECT_GT(moved.moves, 0U);
  EXPECT_EQ(moved.large_stars, 0U);
  options.clean_up.most_move_cells = 0;
  const CleanUpCounters left = reconstruct_tight(points, options).counters.clean_up;
  EXPECT_EQ(left.moves + left.compound_moves, 0U);
  EXPECT_GT(left.large_stars, 0U);
}

// It can take long where much is in doubt: whoever wants to stop is heard.
TEST(CleanUpCells, CanBeStoppedBetweenMoves) {
  class Stop : public Progress {
   public:
    bool report(std::string_view stage, double fraction) override {
      const bool is_within = stage.ends_with("clean_up_cells") && fraction > 0 && fraction < 1;
      reports += is_within ? 1 : 0;
      return !is_within;
    }
    std::size_t reports = 0;
  };
  Stop stop;
  const std::vector<Point> points = shapes::noisy_sphere(6000, 0.05, 1);
  EXPECT_THROW(reconstruct_tight(points, {}, {1, &stop}), Cancelled);
  EXPECT_EQ(stop.reports, 1U);
}

// A labeling with handles, but no cell in doubt: only the samples of the handle are not good.
TEST(CleanUpCells, WithoutUndecidedCellsNothingChanges) {
  std::size_t handles = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Stages s(shapes::noisy_sphere(1500, 0.05, seed));
    const BoundarySamples labels = s.labels();
    const LinkedFacets surface = s.surface(labels);
    CellMarks marks = peel_cells(s.triangulation, surface.set,
                                 mark_cells(s.triangulation, surface, labels.boundary));
    clean_up_cells(s.triangulation, s.poles, marks, {.most_handle_facets = 0});
    for (const CellId c : s.triangulation.cells()) {
      marks.labels[c] = marks.reached[c] != 0 ? CellLabel::out : CellLabel::in;
    }
    marks.conflicts = 0;
    marks.good = VertexSet(s.triangulation.num_vertices(), 0);
    StarCache stars(s.triangulation);
    SpacingCache spacings(s.triangulation, stars);
    HandleLoops loops(s.triangulation, stars, marks.reached);
    const DoubtfulRegion region = find_doubtful_region(s.triangulation, marks, stars, spacings,
                                                       s.triangulation.num_cells(), 0);
    for (const Triangle& loop : loops.find(region)) {
      if (!loops.is_handle(loop, 10000)) continue;
      CellMarks decided = marks;
      decided.good = VertexSet(s.triangulation.num_vertices(), 1);
      for (const VertexId v : loop) decided.good[v] = 0;
      decided.good_vertices = decided.visited_vertices = s.triangulation.num_vertices() - 3;
      const CleanUpCounters counters = clean_up_cells(s.triangulation, s.poles, decided);
      if (counters.defects_before != 0) continue;
      ++handles;
      EXPECT_EQ(counters.undecided_cells, 0U);
      EXPECT_EQ(counters.changed_cells, 0U);
      EXPECT_EQ(decided.reached, marks.reached);
    }
  }
  EXPECT_GE(handles, 10U);
}

// Beside cells in doubt, good vertices are often wrong: at edges, where the peel cuts off corners.
TEST(CleanUpCells, DoubtSpreadsToThinlySupportedCells) {
  const std::string file = std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off";
  const TriangleMesh model = read_mesh(file);
  const std::vector<Point> points(model.points.begin(), model.points.end());
  ReconstructOptions options;
  const ReconstructResult spread = reconstruct_tight(points, options);
  options.clean_up.thin_support = 0;
  const ReconstructResult poor = reconstruct_tight(points, options);
  EXPECT_EQ(poor.counters.clean_up.thin_cells, 0U);
  EXPECT_EQ(spread.counters.clean_up.undecided_cells,
            poor.counters.clean_up.undecided_cells + spread.counters.clean_up.thin_cells);
  const auto rms = [&](const ReconstructResult& result) {
    return surface_distance(result.mesh, model).rms;
  };
  EXPECT_LT(rms(spread), 0.8 * rms(poor));
}

// Each triangle from its smallest corner on.
std::vector<std::array<Point, 3>> in_space(const TriangleMesh& mesh) {
  std::vector<std::array<Point, 3>> triangles;
  for (const Triangle& t : mesh.triangles) {
    std::array<Point, 3> corners{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(CleanUpCells, SameResultForEveryInputOrder) {
  std::size_t compound = 0;
  std::size_t flat = 0;
  std::size_t closed = 0;
  for (const std::vector<Point>& points :
       {vertices_of_model("elephant.off"), shapes::noisy_sphere(1500, 0.06, 5),
        shapes::noisy_sphere(1500, 0.06, 16), shapes::noisy_sphere(1500, 0.05, 2),
        turned_plate(3, false), turned_plate(4, true)}) {
    const ReconstructResult expected = reconstruct_tight(points);
    ASSERT_GT(expected.counters.clean_up.changed_cells, 0U);
    compound += expected.counters.clean_up.compound_moves;
    flat += expected.counters.clean_up.flat_cells;
    closed += expected.counters.clean_up.closed_handles;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const ReconstructResult other = reconstruct_tight(shapes::shuffled(points, seed), {},
                                                        {.threads = static_cast<int>(seed)});
      EXPECT_EQ(in_space(other.mesh), in_space(expected.mesh));
      EXPECT_EQ(other.counters.clean_up.changed_cells, expected.counters.clean_up.changed_cells);
      EXPECT_EQ(other.counters.clean_up.moves, expected.counters.clean_up.moves);
    }
  }
  EXPECT_GT(compound, 0U);
  EXPECT_GT(flat, 0U);
  EXPECT_GT(closed, 0U);
}

// A cost without limit is a large one.
TEST(CleanUpCells, CostsMayBeInfinite) {
  const std::vector<Point> points = shapes::noisy_sphere(800, 0.1, 5);
  using Cost = double CleanUpOptions::*;
  for (const Cost cost :
       {&CleanUpOptions::max_rise, &CleanUpOptions::component_cost, &CleanUpOptions::defect_cost,
        &CleanUpOptions::evidence_weight, &CleanUpOptions::most_clump_share}) {
    ReconstructOptions large;
    large.clean_up.*cost = 0x1p+20;
    const ReconstructResult expected = reconstruct_tight(points, large);
    for (const double more : {1e13, std::numeric_limits<double>::infinity()}) {
      ReconstructOptions options;
      options.clean_up.*cost = more;
      EXPECT_EQ(reconstruct_tight(points, options).mesh, expected.mesh);
    }
  }
}

}  // namespace
}  // namespace cocoon
