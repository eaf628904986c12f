#include "cocone/samples/facet_doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

std::vector<FacetDoubts> doubts_of(const Stages& s, const BoundaryOptions& options,
                                   const Execution& execution = {}) {
  return facet_doubts(s.triangulation, s.poles, s.cocones, options, execution);
}

// How many corners that meet a facet are certain, and how many are not.
struct Counts {
  int certain = 0;
  int doubtful = 0;
};

// Where no facet leaves a doubt the radius must be within its limit; of the radius from Voronoi
// vertices only roundings are unlike.
Counts compare_with_radii(const Stages& s, const BoundaryOptions& options) {
  const std::vector<FacetDoubts> doubts = doubts_of(s, options);
  const IdVector<VertexId, double> radii =
      cocone_radii(s.triangulation, s.dual, s.poles, s.cocones, options.radius_mode);
  VertexSet unbounded(s.triangulation.num_vertices(), 0);
  if (options.radius_mode == RadiusMode::tangent_plane) {
    for (const VertexId v : unbounded_in_plane(s.triangulation, s.dual, s.poles)) unbounded[v] = 1;
  }
  VertexSet doubtful = unbounded;
  for (std::size_t k = 0; k < doubts.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((doubts[k] >> i & 1U) != 0) doubtful[s.cocones.corners[k][i]] = 1;
    }
  }
  Counts counts;
  for (const VertexId v : doubtful.ids()) {
    ++(doubtful[v] != 0 ? counts.doubtful : counts.certain);
    if (doubtful[v] != 0) continue;
    EXPECT_LE(radii[v], options.rho * s.poles.heights[v]) << "sample " << v.index();
  }
  return counts;
}

constexpr BoundaryOptions open_cloud{.rho = 0.3, .radius_mode = RadiusMode::cocone};

TEST(FacetDoubts, WithoutDoubtTheRadiusIsWithinItsLimit) {
  int doubtful = 0;
  for (const auto& points :
       {shapes::random_torus(3000, 0.4, 1), shapes::noisy_sphere(3000, 0.02, 2),
        shapes::dome_patch(30, 0.5, 3), shapes::plate(20, 2), gallery::uniform_cube(2000)}) {
    const Stages s(points);
    for (const double rho : {0.05, 0.13, 0.3, 1 / 1.2}) {
      for (const RadiusMode mode : {RadiusMode::tangent_plane, RadiusMode::cocone}) {
        doubtful += compare_with_radii(s, {.rho = rho, .radius_mode = mode}).doubtful;
      }
    }
  }
  EXPECT_GT(doubtful, 1000);
}

TEST(FacetDoubts, RadiiAreWithinTheirLimitsBesideSliversWithFarCenters) {
  // A flat patch in a general position: flat but for roundings, so that centers are 14 orders of
  // magnitude away, below one more patch.
  std::vector<Point> points;
  for (const auto& [side, z] : {std::pair{30, 0.0}, std::pair{15, 0.5}}) {
    for (const Point& p : shapes::dome_patch(side, 0.8, 8)) {
      points.push_back(
          {(2 * p.x - p.y + 2 * z) / 3, (2 * p.x + 2 * p.y - z) / 3, (-p.x + 2 * p.y + 2 * z) / 3});
    }
  }
  const Stages s(points);
  double farthest = 0;
  for (const CellId c : s.triangulation.finite_cells()) {
    farthest = std::max(farthest, norm(s.dual.centers[c]));
  }
  EXPECT_GT(farthest, 1e13);
  EXPECT_GT(compare_with_radii(s, open_cloud).certain, 100);
}

TEST(FacetDoubts, NearlyAllSamplesOfADenseSurfaceAreCertain) {
  const Stages s(shapes::sphere(5000, 4));
  for (const BoundaryOptions& options : {BoundaryOptions{}, open_cloud}) {
    const Counts counts = compare_with_radii(s, options);
    EXPECT_GT(counts.certain, 4900) << "mode " << static_cast<int>(options.radius_mode);
  }
}

TEST(FacetDoubts, OnlyCornersThatAreMetAreInDoubt) {
  const Stages s(gallery::uniform_cube(1000));
  const std::vector<FacetDoubts> doubts = doubts_of(s, {.rho = 1e-6});
  int doubtful = 0;
  for (std::size_t k = 0; k < doubts.size(); ++k) {
    EXPECT_EQ(doubts[k] & 7U & ~s.cocones.met_corners(k), 0U);
    doubtful += (doubts[k] & 7U) != 0;
  }
  EXPECT_GT(doubtful, 1000);
}

TEST(FacetDoubts, TellWhereNormalsDisagree) {
  const Stages s(shapes::noisy_sphere(3000, 0.02, 5));
  const BoundaryOptions options;
  const std::vector<FacetDoubts> doubts = doubts_of(s, options);
  int disagreeing = 0;
  for (std::size_t k = 0; k < doubts.size(); ++k) {
    const Triangle& corners = s.cocones.corners[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const bool agree = normals_agree(s.poles, corners[i], corners[(i + 1) % 3], options);
      EXPECT_EQ(doubts[k] >> (3 + i) & 1U, agree ? 0U : 1U);
      disagreeing += agree ? 0 : 1;
    }
    EXPECT_EQ(doubts[k] & ~(ratio_doubts | normals_disagree), 0);
  }
  EXPECT_GT(disagreeing, 50);
}

TEST(FacetDoubts, ThinFacetsAndLostScalesAreInDoubt) {
  // Products of six lengths leave the range of doubles: nothing may be certain by accident.
  const std::vector<Point> points = shapes::sphere(500, 6);
  for (const double scale : {0x1p-99, 0x1p-60, 0x1p60, 0x1p99}) {
    std::vector<Point> scaled;
    for (const Point& p : points) scaled.push_back(scale * p);
    compare_with_radii(Stages(scaled), {.rho = 0.01});
  }
  // A needle: the triangle is far thinner than the bound for roundings.
  Stages needle(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0x1p-12, 0}, {1, 1, 1}, {1, -1, 1}});
  for (double& height : needle.poles.heights) height = 1e30;
  const std::vector<FacetDoubts> doubts = doubts_of(needle, {});
  int thin = 0;
  for (std::size_t k = 0; k < doubts.size(); ++k) {
    Triangle corners = needle.cocones.corners[k];
    double z = 0;
    for (const VertexId v : corners) z += needle.triangulation.point(v).z;
    if (z != 0 || needle.cocones.met_corners(k) == 0) continue;
    ++thin;
    EXPECT_EQ(doubts[k] & 7U, needle.cocones.met_corners(k));
  }
  EXPECT_EQ(thin, 1);
}

// Normals nearly in the planes of facets, or as steep as the cone: each leans so off one of the
// facets at its sample. Heights so large that nothing but a guard leaves a doubt, and others.
void make_steep(Stages& s, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t k = 0; k < s.cocones.facets.size(); ++k) {
    const Triangle& corners = s.cocones.corners[k];
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = s.triangulation.point(corners[i]);
    const Vec3 facet_normal = unit(cross(p[1] - p[0], p[2] - p[0]));
    const VertexId v = corners[random.below(3)];
    const double beside = std::exp2(random.uniform(-13, -7)) * (random.uniform() < 0.5 ? -1 : 1);
    const double sine = (random.uniform() < 0.5 ? s.cocones.cosine : 0) + beside;
    const double sign = random.uniform() < 0.5 ? -1 : 1;
    s.poles.normals[v] =
        std::sqrt(1 - sine * sine) * unit(p[1] - p[0]) + sign * sine * facet_normal;
    s.poles.heights[v] = std::exp(random.uniform(-3, 60));
  }
}

// How far a facet is from where there is no doubt about one corner: above 1 there is. By the
// formulas of the header, one by one, and with the room for roundings.
double doubt_by_definition(const Stages& s, std::size_t k, std::size_t i,
                           const BoundaryOptions& options) {
  std::array<Point, 3> p;
  for (std::size_t j = 0; j < 3; ++j) p[j] = s.triangulation.point(s.cocones.corners[k][j]);
  std::sort(p.begin(), p.end());
  const VertexId v = s.cocones.corners[k][i];
  const Vec3 normal = s.poles.normals[v];
  const Vec3 u = p[1] - p[0], w = p[2] - p[0];
  const Vec3 facet_normal = cross(u, w);
  const double sine_of_facet = norm(facet_normal) / (norm(u) * norm(w));
  const Vec3 to_center = (1 / (2 * squared_norm(facet_normal))) *
                         cross(squared_norm(u) * w - squared_norm(w) * u, facet_normal);
  const double radius = norm(to_center);
  const double along = std::abs(dot(p[0] + to_center - s.triangulation.point(v), normal));
  const double tilt = std::abs(dot(facet_normal, normal)) / norm(facet_normal);
  const bool in_plane = options.radius_mode == RadiusMode::tangent_plane;
  const double steepness = in_plane ? tilt : tilt - s.cocones.cosine;
  const double reach = (in_plane ? 0 : s.cocones.cosine * radius) + along;
  const double limit = options.rho * s.poles.heights[v] / std::sqrt(1 + 0x1p-10);
  const double least_sine = 0x1p-10;
  if (steepness <= 0) return 2;
  return std::max({std::hypot(radius, reach / steepness) / limit, least_sine / steepness,
                   least_sine / sine_of_facet});
}

TEST(FacetDoubts, AreThoseOfTheirDefinition) {
  Counts counts;
  int guarded = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const auto& points : {shapes::noisy_sphere(1000, 0.05, seed), gallery::uniform_cube(1000),
                               shapes::latitude_sphere(4, 3000)}) {
      for (const RadiusMode mode : {RadiusMode::tangent_plane, RadiusMode::cocone}) {
        const BoundaryOptions options{.rho = 0.3, .radius_mode = mode};
        Stages s(points);
        make_steep(s, seed);
        const std::vector<FacetDoubts> doubts = doubts_of(s, options);
        for (std::size_t k = 0; k < doubts.size(); ++k) {
          for (std::size_t i = 0; i < 3; ++i) {
            const double expected = doubt_by_definition(s, k, i, options);
            if ((s.cocones.met_corners(k) >> i & 1U) == 0 || std::abs(expected - 1) < 1e-6)
              continue;
            EXPECT_EQ(doubts[k] >> i & 1U, expected > 1 ? 1U : 0U) << expected;
            ++(expected > 1 ? counts.doubtful : counts.certain);
            const VertexId v = s.cocones.corners[k][i];
            if (expected > 1 && s.poles.heights[v] > 1e15) ++guarded;
          }
        }
      }
    }
  }
  EXPECT_GT(counts.certain, 10000);
  EXPECT_GT(counts.doubtful, 10000);
  EXPECT_GT(guarded, 1000);
}

TEST(FacetDoubts, ThreadsDoNotShow) {
  const Stages s(shapes::noisy_sphere(20000, 0.002, 7));
  EXPECT_EQ(doubts_of(s, {}, {.threads = 3}), doubts_of(s, {}));
}

}  // namespace
}  // namespace cocoon
