#include "cocone/boundary_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
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

// Whatever the thresholds: no sample behind the outer row is taken for a boundary, a larger rho
// finds fewer, and the surface has the outline alone for its rim.
TEST(BoundarySamples, RimOfAPatchForManyThresholds) {
  const int side = 30;
  for (const std::uint64_t seed : {2, 3}) {
    const std::vector<Point> points = shapes::dome_patch(side, 0.3, seed);
    const Stages s(points);
    for (const RadiusMode mode : {RadiusMode::cocone, RadiusMode::tangent_plane}) {
      for (const double alpha : {0.14, std::numbers::pi / 6, std::numbers::pi / 3}) {
        std::size_t most = points.size();
        for (const double rho : {0.13, 0.2, 0.3, 0.5, 0.83}) {
          SCOPED_TRACE(testing::Message() << rho << ' ' << alpha);
          ReconstructOptions options = open_cloud_defaults();
          options.boundary = {.rho = rho, .alpha_cosine = std::cos(alpha), .radius_mode = mode};
          const BoundarySamples labels = s.labels(options.boundary);
          for (const Point& p : boundary_points(s, labels)) {
            EXPECT_LT(std::min({p.x, p.y, 1 - p.x, 1 - p.y}), 0.5 / (side - 1));
          }
          EXPECT_LE(labels.count, most);
          most = labels.count;
          const MeshReport surface = mesh_check(reconstruct_cocone(points, options).mesh);
          EXPECT_EQ(surface.boundary_curves, 1U);
          EXPECT_EQ(surface.euler, 1);
          EXPECT_TRUE(surface.edge_manifold && surface.vertex_manifold);
        }
        EXPECT_GT(most, 30U);
      }
    }
  }
}

// Noise in shares of the radius; samples are 0.065 apart. The radius in the tangent plane bears it
// better. Measured: about 1.3 and 2.1 % of the samples, then 21 and 30 %, 68 and 83 %.
TEST(BoundarySamples, NoiseMakesMore) {
  struct Limits {
    double noise;
    double least;
    double most;
  };
  for (const auto& [noise, least, most] :
       {Limits{0.002, 0.002, 0.04}, Limits{0.01, 0.1, 0.4}, Limits{0.03, 0.5, 0.95}}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Stages s(shapes::noisy_sphere(3000, noise, seed));
      const std::size_t plane = s.labels({.radius_mode = RadiusMode::tangent_plane}).count;
      const std::size_t cocone = s.labels({.radius_mode = RadiusMode::cocone}).count;
      EXPECT_GT(static_cast<double>(plane), least * 3000) << noise;
      EXPECT_LT(plane, cocone) << noise;
      EXPECT_LT(static_cast<double>(cocone), most * 3000) << noise;
    }
  }
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
