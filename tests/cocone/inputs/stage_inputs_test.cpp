#include "cocone/inputs/stage_inputs.h"

#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

#include "cocone/clean_up_cells.h"
#include "cocone/dynamic_tight_cocone.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/reconstruct.h"
#include "cocone/robust_cocone.h"
#include "cocone/surface_mesh.h"
#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

struct AllStages : Stages {
  explicit AllStages(const std::vector<Point>& points)
      : Stages(points),
        boundary(labels().boundary),
        candidates(candidate_triangles(triangulation, cocones, boundary)),
        pruned(prune_sharp_edges(triangulation, candidates)),
        triangles(extract_manifold(triangulation, pruned.left, pruned.umbrella).triangles),
        marks(mark_cells(triangulation, triangles, boundary)),
        peeled(peel_cells(triangulation, triangles.set, marks)) {}
  ConeSides sides() const {
    return cone_sides(triangulation, dual, poles.normals, CoconeOptions().cosine);
  }
  VertexSet boundary;
  FacetSet candidates;
  PrunedCandidates pruned;
  LinkedFacets triangles;
  CellMarks marks;
  CellMarks peeled;
};

// A large and a small one: what is mixed up would be read beyond its end, or not be read at all.
class MixedStageInputs : public testing::Test {
 protected:
  void expect_refused_either_way() {
    EXPECT_NO_THROW(run_all(large_, large_));
    for (const auto& [own, other] : {std::pair{&large_, &small_}, std::pair{&small_, &large_}}) {
      expect_each_refused(*own, *other);
    }
  }

 private:
  static void run_all(const AllStages& own, const AllStages& other) {
    const Triangulation& t = own.triangulation;
    compute_poles(t, other.dual);
    intersect_cocones(t, other.dual, other.poles);
    boundary_samples(t, other.dual, other.poles, other.cocones);
    candidate_triangles(t, other.cocones, other.boundary);
    prune_sharp_edges(t, other.candidates);
    extract_manifold(t, other.pruned.left, other.pruned.umbrella);
    mark_cells(t, other.triangles, other.boundary);
    CellMarks peeled = peel_cells(t, other.triangles.set, other.marks);
    clean_up_cells(t, other.poles, peeled);
    surface_between(t, peeled);
    good_vertices(other.triangles, other.boundary);
  }

  static void expect_each_refused(const AllStages& own, const AllStages& other) {
    const Triangulation& t = own.triangulation;
    EXPECT_THROW(compute_poles(t, other.dual), InputError);
    EXPECT_THROW(compute_poles(t, Dual()), InputError);
    EXPECT_THROW(intersect_cocones(t, other.dual, own.poles), InputError);
    EXPECT_THROW(intersect_cocones(t, own.dual, other.poles), InputError);
    EXPECT_THROW(intersect_cocones(t, other.sides()), InputError);
    EXPECT_THROW(boundary_samples(t, other.dual, own.poles, own.cocones), InputError);
    EXPECT_THROW(boundary_samples(t, own.dual, other.poles, own.cocones), InputError);
    EXPECT_THROW(boundary_samples(t, own.dual, own.poles, other.cocones), InputError);
    EXPECT_THROW(judge_samples(t, own.dual, own.poles, other.cocones), InputError);
    EXPECT_THROW(candidate_triangles(t, other.cocones, own.boundary), InputError);
    EXPECT_THROW(candidate_triangles(t, own.cocones, other.boundary), InputError);
    EXPECT_THROW(candidate_triangles(t, own.cocones, {}), InputError);
    EXPECT_THROW(prune_sharp_edges(t, other.candidates), InputError);
    EXPECT_THROW(extract_manifold(t, other.pruned.left, own.pruned.umbrella), InputError);
    EXPECT_THROW(extract_manifold(t, own.pruned.left, other.pruned.umbrella), InputError);
    EXPECT_THROW(mark_cells(t, other.triangles, own.boundary), InputError);
    EXPECT_THROW(mark_cells(t, own.triangles, other.boundary), InputError);
    EXPECT_THROW(peel_cells(t, other.triangles.set, own.marks), InputError);
    EXPECT_THROW(peel_cells(t, own.triangles.set, other.marks), InputError);
    CellMarks of_own = own.peeled;
    CellMarks of_other = other.peeled;
    EXPECT_THROW(clean_up_cells(t, other.poles, of_own), InputError);
    EXPECT_THROW(clean_up_cells(t, own.poles, of_other), InputError);
    CellMarks not_peeled;
    EXPECT_THROW(clean_up_cells(t, own.poles, not_peeled), InputError);
  }

  const AllStages large_{shapes::noisy_sphere(600, 0.01, 1)};
  const AllStages small_{shapes::noisy_sphere(200, 0.01, 2)};
};

TEST_F(MixedStageInputs, OfAnotherTriangulationAreRefused) { expect_refused_either_way(); }

TEST(StageInputsLeftOut, VerticesOfTrianglesNeedFlags) {
  const AllStages s(shapes::noisy_sphere(300, 0.01, 8));
  EXPECT_THROW(good_vertices(s.triangles, VertexSet(s.boundary.size() / 2, 0)), InputError);
  EXPECT_THROW(vertices_with_umbrella(s.triangles, s.boundary.size() / 2, 0), InputError);
}

// Positions that do not lead from the points before to those after.
TEST(StageInputsLeftOut, PointsThatStayAreWhereTheyWere) {
  const std::vector<Point> points = shapes::noisy_sphere(300, 0.01, 9);
  std::vector<PointId> positions;
  for (std::size_t i = 0; i < points.size(); ++i) positions.emplace_back(i);
  DynamicTightCocone surface;
  surface.reconstruct(points);
  const std::vector<PointId> too_few(positions.begin(), positions.end() - 1);
  EXPECT_THROW(surface.replace(points, too_few), InputError);
  std::vector<PointId> beyond = positions;
  beyond.back() = PointId(points.size());
  EXPECT_THROW(surface.replace(points, beyond), InputError);
  std::vector<PointId> mixed_up = positions;
  std::swap(mixed_up[0], mixed_up[1]);
  EXPECT_THROW(surface.replace(points, mixed_up), InputError);
  EXPECT_EQ(surface.replace(points, positions).mesh.triangles,
            reconstruct_tight(points).mesh.triangles);
}

TEST(StageInputsLeftOut, NormalsAloneAreEnoughForCoconesButNotForTheBoundary) {
  const AllStages s(shapes::noisy_sphere(300, 0.01, 3));
  Poles normals;
  normals.normals = s.poles.normals;
  const Cocones cocones = intersect_cocones(s.triangulation, s.dual, normals);
  EXPECT_EQ(cocones.facets, s.cocones.facets);
  EXPECT_THROW(boundary_samples(s.triangulation, s.dual, normals, cocones), InputError);
}

TEST(StageInputsLeftOut, CellsThatWereNotPeeledHaveNoSurface) {
  AllStages s(shapes::noisy_sphere(300, 0.01, 4));
  EXPECT_THROW(surface_between(s.triangulation, s.marks), InputError);
  EXPECT_THROW(open_cavities(s.triangulation, s.triangles.set, s.marks), InputError);
}

TEST(StageInputsLeftOut, FacetsOfNoTriangulationAreRefused) {
  const Triangulation triangulation = delaunay(shapes::sphere(50, 1)).triangulation;
  const VertexSet flags(triangulation.num_vertices(), 0);
  EXPECT_THROW(mark_cells(triangulation, LinkedFacets(), flags), InputError);
  EXPECT_THROW(extract_manifold(triangulation, LinkedFacets(), flags), InputError);
}

TEST(StageInputsLeftOut, MarksThatLackAPartAreRefused) {
  const AllStages s(shapes::noisy_sphere(300, 0.01, 11));
  const auto refused = [&](auto change) {
    CellMarks marks = s.peeled;
    change(marks);
    EXPECT_THROW(open_cavities(s.triangulation, s.triangles.set, marks), InputError);
    EXPECT_THROW(peel_cells(s.triangulation, s.triangles.set, marks), InputError);
  };
  refused([](CellMarks& marks) { marks.labels = {}; });
  refused([](CellMarks& marks) { marks.good = {}; });
  refused([](CellMarks& marks) { marks.visited = {}; });
}

TEST(StageInputsLeftOut, SidesOfNoCellMakeNoCocones) {
  const AllStages s(shapes::noisy_sphere(300, 0.01, 12));
  EXPECT_THROW(intersect_cocones(s.triangulation, ConeSides{}), InputError);
  EXPECT_EQ(intersect_cocones(s.triangulation, s.sides()).facets, s.cocones.facets);
}

// Of a noisy sphere, where good vertices disagree: then known labels are asked for.
TEST(StageInputsLeftOut, KnownLabelsAreThoseOfAllCells) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.03, 5);
  bool asked = false;
  const auto labels_of_one = [&](const Triangulation&, const FacetSet&, const Execution&) {
    asked = true;
    KnownLabels known;
    known.labels = IdVector<CellId, CellLabel>(1, CellLabel::in);
    return known;
  };
  EXPECT_THROW(reconstruct_tight_with_labels(points, labels_of_one), InputError);
  EXPECT_TRUE(asked);
  const AllStages s(points);
  EXPECT_GT(s.marks.conflicts, 0U);
  EXPECT_THROW(mark_cells(s.triangulation, s.triangles, s.boundary, labels_of_one), InputError);
}

TEST(StageInputs, OptionsOutOfRangeAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const AllStages s(shapes::noisy_sphere(300, 0.01, 6));
  const Triangulation& t = s.triangulation;
  for (const double cosine : {-0.5, 67.5, nan}) {
    EXPECT_THROW(intersect_cocones(t, s.dual, s.poles, {.cosine = cosine}), InputError);
    EXPECT_THROW(poles_and_sides(t, s.dual, cosine), InputError);
    EXPECT_THROW(dual_and_poles(t, cosine), InputError);
    ConeSides sides = s.sides();
    sides.cosine = cosine;
    EXPECT_THROW(intersect_cocones(t, sides), InputError);
  }
  for (const BoundaryOptions& options :
       {BoundaryOptions{.rho = -1}, BoundaryOptions{.rho = nan},
        BoundaryOptions{.alpha_cosine = 30}, BoundaryOptions{.alpha_cosine = nan}}) {
    EXPECT_THROW(boundary_samples(t, s.dual, s.poles, s.cocones, options), InputError);
    EXPECT_THROW(judge_samples(t, s.dual, s.poles, s.cocones, options), InputError);
  }
  EXPECT_THROW(prune_sharp_edges(t, s.candidates, {.sharp_cosine = nan}), InputError);
  EXPECT_THROW(prune_sharp_edges(t, s.candidates, {.keep_cosine = nan}), InputError);
  EXPECT_THROW(good_vertices(s.triangles, s.boundary, {.fold_cosine = nan}), InputError);
  EXPECT_THROW(good_vertices(s.triangles, s.boundary, {.crease_cosine = nan}), InputError);
  EXPECT_THROW(effective_options({.max_contradicted_likely = 1.5}), InputError);
  for (const CleanUpOptions& options :
       {CleanUpOptions{.stretch_cost = -1}, CleanUpOptions{.evidence_weight = nan},
        CleanUpOptions{.thin_support = 5}, CleanUpOptions{.deep_cosine = 60},
        CleanUpOptions{.pole_good_share = 1.5}, CleanUpOptions{.mark_credit = 1.5},
        CleanUpOptions{.near_pole_ratio = 2.5}, CleanUpOptions{.full_pole_ratio = 0.5}}) {
    CellMarks marks = s.peeled;
    EXPECT_THROW(clean_up_cells(t, s.poles, marks, options), InputError);
  }
}

TEST(StageInputs, NoiseOptionsOutOfRangeAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> points = shapes::noisy_sphere(300, 0.01, 10);
  for (const NoiseOptions& options :
       {NoiseOptions{.neighbors = 0}, NoiseOptions{.outlier_ratio = nan},
        NoiseOptions{.clump_share = 2}, NoiseOptions{.deep_cosine = 60}}) {
    EXPECT_THROW(reconstruct_robust(points, options), InputError);
  }
}

TEST(StageInputs, WholeReconstructionsRefuseThemBeforeTheyBegin) {
  const std::vector<Point> points = shapes::noisy_sphere(300, 0.01, 7);
  ReconstructOptions options;
  options.boundary.rho = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(reconstruct_tight(points, options), InputError);
  EXPECT_THROW(reconstruct_cocone(points, options), InputError);
  EXPECT_THROW((DynamicTightCocone(options)), InputError);
}

TEST(StageInputsLeftOut, ATriangulationOfOtherPointsIsRefused) {
  const std::vector<Point> points = shapes::noisy_sphere(300, 0.01, 5);
  const std::vector<Point> fewer(points.begin(), points.end() - 1);
  EXPECT_THROW(reconstruct_tight(delaunay(points).triangulation, fewer), InputError);
  EXPECT_THROW(reconstruct_tight(delaunay(fewer).triangulation, points), InputError);
  EXPECT_THROW(reconstruct_tight(Triangulation(), points), InputError);
}

}  // namespace
}  // namespace cocoon
