#include "cocone/boundary_samples.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "ref/cgal_cocone.h"
#include "ref/cgal_delaunay.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

std::set<Point> boundary_points(const Stages& s, const BoundarySamples& labels) {
  std::set<Point> points;
  for (const VertexId v : s.triangulation.vertices()) {
    if (labels.boundary[v] != 0) points.insert(s.triangulation.point(v));
  }
  return points;
}

const BoundaryOptions open_cloud{.rho = 0.3, .radius_mode = RadiusMode::cocone};

TEST(BoundarySamples, NoneOnADenselySampledSphere) {
  const BoundarySamples labels = Stages(shapes::sphere(3000, 1)).labels();
  EXPECT_EQ(labels.count, 0U);
  EXPECT_EQ(labels.interior(), 3000U);
}

TEST(BoundarySamples, RimOfAPatch) {
  const int side = 30;
  const std::vector<Point> points = shapes::dome_patch(side, 0.3, 2);
  const Stages s(points);
  const BoundarySamples labels = s.labels(open_cloud);
  // every boundary sample is one of the outer two rows, and no side of the rim is without
  const double margin = 1.6 / (side - 1);
  std::array<int, 4> found{};
  for (const Point& p : boundary_points(s, labels)) {
    const std::array<double, 4> to_sides{p.x, p.y, 1 - p.x, 1 - p.y};
    EXPECT_LT(*std::min_element(to_sides.begin(), to_sides.end()), margin);
    for (std::size_t i = 0; i < 4; ++i) found[i] += to_sides[i] < margin;
  }
  for (const int count : found) EXPECT_GT(count, side / 3);
}

TEST(BoundarySamples, DoNotDependOnInputOrderOrThreads) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.008, 3);
  const Stages s(points);
  const BoundarySamples labels = s.labels();
  ASSERT_GT(labels.count, 50U);
  ASSERT_GT(labels.recovered, 0U);
  const Stages other(shapes::shuffled(points, 9));
  EXPECT_EQ(boundary_points(s, labels), boundary_points(other, other.labels()));
  const BoundarySamples threaded =
      boundary_samples(s.triangulation, s.dual, s.poles, s.cocones, {}, {.threads = 4});
  EXPECT_EQ(threaded.boundary, labels.boundary);
}

TEST(BoundarySamples, AreTheSameWhateverTheNumbering) {
  // The oracle's triangulation numbers vertices and cells in another way.
  std::size_t recovered = 0;
  for (const auto& points : {shapes::noisy_sphere(2000, 0.01, 4), shapes::plate(20, 2),
                             shapes::random_torus(1500, 0.3, 5)}) {
    const Stages s(points);
    const Stages renumbered(ref::cgal_delaunay(points));
    for (const BoundaryOptions& options : {BoundaryOptions{}, open_cloud}) {
      const BoundarySamples labels = s.labels(options);
      recovered += labels.recovered;
      EXPECT_EQ(boundary_points(s, labels),
                boundary_points(renumbered, renumbered.labels(options)));
    }
  }
  EXPECT_GT(recovered, 0U);
}

// Labels and candidates of the stages, in the ids of the input.
ref::CgalCocone as_input_ids(const Stages& s, const BoundarySamples& labels) {
  ref::CgalCocone result{IdVector<PointId, std::uint8_t>(s.triangulation.num_vertices(), 0), {}};
  for (const VertexId v : s.triangulation.vertices()) {
    result.boundary[s.triangulation.point_of_vertex(v)] = labels.boundary[v];
  }
  const FacetSet candidates = candidate_triangles(s.triangulation, s.cocones, labels.boundary);
  candidates.for_each(s.triangulation, [&](FacetId f) {
    std::array<PointId, 3> ids;
    const auto corners = s.triangulation.facet_vertices(f);
    for (std::size_t k = 0; k < 3; ++k) ids[k] = s.triangulation.point_of_vertex(corners[k]);
    std::sort(ids.begin(), ids.end());
    result.candidates.push_back(ids);
  });
  std::sort(result.candidates.begin(), result.candidates.end());
  return result;
}

// On points in general position nothing is decided by the last bit, so everything must agree.
TEST(BoundarySamples, LabelsAndCandidatesAgreeWithThePlainImplementation) {
  for (const auto& points :
       {shapes::noisy_sphere(1500, 0.01, 6), shapes::random_torus(1500, 0.4, 7),
        shapes::dome_patch(25, 0.5, 8), shapes::cut_sphere(1000, 0.5, 9),
        shapes::random_cube(500, 10), shapes::noisy_sphere(1000, 0.03, 11)}) {
    const Stages s(points);
    for (const bool tangent_plane : {true, false}) {
      for (const double rho : {1 / 1.2, 0.3}) {
        const BoundarySamples labels = s.labels(
            {.rho = rho,
             .radius_mode = tangent_plane ? RadiusMode::tangent_plane : RadiusMode::cocone});
        const ref::CgalCocone own = as_input_ids(s, labels);
        const ref::CgalCocone plain =
            ref::cgal_cocone(points, {.rho = rho, .tangent_plane_radius = tangent_plane});
        EXPECT_EQ(own.boundary, plain.boundary) << "rho " << rho << " plane " << tangent_plane;
        EXPECT_EQ(own.candidates, plain.candidates) << "rho " << rho << " plane " << tangent_plane;
      }
    }
  }
}

TEST(BoundarySamples, ThinPlateHasNoInteriorSampleAtSmallRho) {
  EXPECT_EQ(Stages(shapes::plate(30, 1)).labels({.rho = 0.3}).interior(), 0U);
}

}  // namespace
}  // namespace cocoon
