#include "cocone/cocones.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "cocone/samples/cocone_radii.h"
#include "cocone/samples/double_cone.h"
#include "delaunay/circulate.h"
#include "ref/dense_cocone_sampling.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

constexpr double cosine = 0.38268343236508977;

TEST(DoubleCone, SidesAreOrderedAlongTheNormal) {
  const Vec3 n{0, 0, 1};
  EXPECT_EQ(cone_side({0, 0, -1}, n, cosine * cosine), ConeSide::below);
  EXPECT_EQ(cone_side({1, 0, -0.1}, n, cosine * cosine), ConeSide::low);
  EXPECT_EQ(cone_side({1, 0, 0.1}, n, cosine * cosine), ConeSide::high);
  EXPECT_EQ(cone_side({0, 0.1, 1}, n, cosine * cosine), ConeSide::above);
  EXPECT_EQ(cone_side({0, 0, 0}, n, cosine * cosine), ConeSide::low);
}

TEST(DoubleCone, SideDoesNotDependOnLength) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 n = random.on_unit_sphere();
    const Vec3 x = random.on_unit_sphere();
    const ConeSide side = cone_side(x, n, cosine * cosine);
    for (const double scale : {0x1p-1000, 0x1p-600, 0x1p-300, 0x1p+300, 0x1p+600, 0x1p+1000}) {
      EXPECT_EQ(cone_side(scale * x, n, cosine * cosine), side) << scale;
    }
  }
}

TEST(Cocones, EndPointTestAgreesWithDenseSampling) {
  Random random(4);
  int decided = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 n = random.on_unit_sphere();
    const bool is_ray = i % 2 == 0;
    const Vec3 from = random.uniform(0.1, 3) * random.on_unit_sphere();
    const Vec3 to = is_ray ? random.on_unit_sphere() : 2.0 * random.on_unit_sphere();
    const auto sampled = ref::sample_cocone({from, to, is_ray}, {}, n, cosine, 4001);
    if (sampled.borderline) continue;
    ++decided;
    const double squared = cosine * cosine;
    EXPECT_EQ(meets_cocone(cone_side(from, n, squared), cone_side(to, n, squared)), sampled.meets)
        << "edge " << i;
  }
  EXPECT_GT(decided, 3500);
}

TEST(Cocones, ListsFacetsOnceAscendingByTheirCanonicalIds) {
  const Stages s(shapes::random_torus(800, 0.4, 5));
  const std::vector<FacetId>& facets = s.cocones.facets;
  ASSERT_EQ(facets.size(), s.cocones.rows.size());
  ASSERT_EQ(facets.size(), s.cocones.mirrors.size());
  ASSERT_EQ(facets.size(), s.cocones.corners.size());
  EXPECT_TRUE(std::is_sorted(facets.begin(), facets.end(), std::less_equal<>()));
  for (std::size_t k = 0; k < facets.size(); ++k) {
    EXPECT_TRUE(s.triangulation.is_finite_facet(facets[k]));
    EXPECT_EQ(s.triangulation.canonical(facets[k]), facets[k]);
    EXPECT_NE(s.cocones.rows[k], 0);
    EXPECT_EQ(s.cocones.mirrors[k], s.triangulation.mirror(facets[k]));
    EXPECT_EQ(s.cocones.corners[k], s.triangulation.facet_vertices(facets[k]));
    for (std::size_t i = 0; i < 3; ++i) {
      const int j = facet_corners[index_of(facets[k])][i];
      EXPECT_EQ(s.cocones.met_corners(k) >> i & 1U, unsigned{s.cocones.rows[k]} >> j & 1U);
    }
  }
}

// The bits of a facet, given by its canonical id; 0 if it is not in the list.
unsigned row_of(const Cocones& cocones, FacetId f) {
  const auto place = std::lower_bound(cocones.facets.begin(), cocones.facets.end(), f);
  if (place == cocones.facets.end() || *place != f) return 0;
  return cocones.rows[static_cast<std::size_t>(place - cocones.facets.begin())];
}

TEST(Cocones, BitsAreThoseOfTheDualEdges) {
  const Stages s(shapes::dome_patch(12, 0.6, 6));
  int met = 0;
  for (const CellId c : s.triangulation.cells()) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (!s.triangulation.is_finite_facet(f) || s.triangulation.canonical(f) != f) continue;
      const DualEdge edge = dual_edge(s.triangulation, s.dual, f);
      for (const int j : facet_corners[i]) {
        const VertexId v = s.triangulation.vertex(c, j);
        const auto sampled =
            ref::sample_cocone(edge, s.triangulation.point(v), s.poles.normals[v], cosine, 2001);
        if (sampled.borderline) continue;
        EXPECT_EQ((row_of(s.cocones, f) >> j) & 1U, sampled.meets ? 1U : 0U);
        met += sampled.meets;
      }
    }
  }
  EXPECT_GT(met, 100);
}

// The radius by sampling every dual edge of the sample.
double sampled_radius(const Stages& s, VertexId v, bool& borderline) {
  double radius = 0;
  for_each_facet_around_vertex(s.triangulation, s.stars, v, [&](FacetId f) {
    if (!s.triangulation.is_finite_facet(f)) return;
    const auto sampled =
        ref::sample_cocone(dual_edge(s.triangulation, s.dual, f), s.triangulation.point(v),
                           s.poles.normals[v], cosine, 2001);
    radius = std::max(radius, sampled.radius);
    borderline |= sampled.borderline;
  });
  return radius;
}

TEST(Cocones, RadiusAgreesWithDenseSampling) {
  int compared = 0;
  int infinite = 0;
  for (const auto& points : {shapes::random_torus(400, 0.4, 7), shapes::dome_patch(12, 0.5, 8)}) {
    const Stages s(points);
    const IdVector<VertexId, double> radii =
        cocone_radii(s.triangulation, s.dual, s.poles, s.cocones, RadiusMode::cocone);
    for (const VertexId v : s.triangulation.vertices()) {
      bool borderline = false;
      const double expected = sampled_radius(s, v, borderline);
      const double radius = radii[v];
      if (std::isinf(expected)) {
        ++infinite;
        EXPECT_TRUE(std::isinf(radius));
        continue;
      }
      EXPECT_GE(radius, expected * (1 - 1e-9));
      if (borderline) continue;
      ++compared;
      EXPECT_LE(radius, expected * (1 + 1e-6));
    }
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(infinite, 3);
}

TEST(Cocones, RadiiOfSomeSamplesAreThoseOfAll) {
  const Stages s(shapes::noisy_sphere(1000, 0.02, 13));
  VertexSet some(s.triangulation.num_vertices(), 0);
  for (const VertexId v : some.ids()) some[v] = v.index() % 7 == 0 ? 1 : 0;
  for (const RadiusMode mode : {RadiusMode::cocone, RadiusMode::tangent_plane}) {
    const IdVector<VertexId, double> all =
        cocone_radii(s.triangulation, s.dual, s.poles, s.cocones, mode);
    const IdVector<VertexId, double> radii =
        cocone_radii(s.triangulation, s.dual, s.poles, s.cocones, mode, some);
    for (const VertexId v : some.ids()) EXPECT_EQ(radii[v], some[v] != 0 ? all[v] : 0);
  }
}

TEST(Cocones, TangentPlaneRadiusIsTheConeOpenedByZero) {
  // In the limit of a cone that leaves only the tangent plane both radii are the same.
  const std::vector<Point> points = shapes::random_torus(400, 0.4, 9);
  const Stages s(points);
  const Cocones flat = intersect_cocones(s.triangulation, s.dual, s.poles, {.cosine = 1e-7});
  const auto radii = [&](const Cocones& cocones, RadiusMode mode) {
    return cocone_radii(s.triangulation, s.dual, s.poles, cocones, mode);
  };
  const IdVector<VertexId, double> plane = radii(s.cocones, RadiusMode::tangent_plane);
  const IdVector<VertexId, double> limit = radii(flat, RadiusMode::cocone);
  const IdVector<VertexId, double> opened = radii(s.cocones, RadiusMode::cocone);
  for (const VertexId v : s.triangulation.vertices()) {
    if (is_hull_vertex(s.triangulation, s.stars, v)) continue;
    EXPECT_NEAR(plane[v], limit[v], 1e-4 * limit[v]);
    EXPECT_LE(plane[v], opened[v] * (1 + 1e-12));
  }
}

TEST(Cocones, SidesFoundWithThePolesAreThoseFoundAlone) {
  const Stages s(shapes::random_torus(5000, 0.4, 12));
  const auto [poles, sides] = poles_and_sides(s.triangulation, s.dual, cosine, {.threads = 3});
  EXPECT_EQ(poles.normals, s.poles.normals);
  EXPECT_EQ(poles.heights, s.poles.heights);
  EXPECT_EQ(sides.of_cells, cone_sides(s.triangulation, s.dual, poles.normals, cosine).of_cells);
  EXPECT_EQ(intersect_cocones(s.triangulation, sides).facets, s.cocones.facets);
  EXPECT_EQ(intersect_cocones(s.triangulation, sides).rows, s.cocones.rows);
}

TEST(Cocones, ThreadsDoNotShow) {
  const Stages s(shapes::random_torus(20000, 0.4, 10));
  const Execution threaded{.threads = 4};
  const Cocones cocones = intersect_cocones(s.triangulation, s.dual, s.poles, {}, threaded);
  EXPECT_EQ(cocones.facets, s.cocones.facets);
  EXPECT_EQ(cocones.rows, s.cocones.rows);
  for (const RadiusMode mode : {RadiusMode::cocone, RadiusMode::tangent_plane}) {
    EXPECT_EQ(cocone_radii(s.triangulation, s.dual, s.poles, cocones, mode, threaded),
              cocone_radii(s.triangulation, s.dual, s.poles, cocones, mode));
  }
}

}  // namespace
}  // namespace cocoon
