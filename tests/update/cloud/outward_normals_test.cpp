#include "update/cloud/outward_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "geom/random/random.h"
#include "geom/triangle_normal.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A block, and a scan of its top, which is at z = 12, with a hill, and the same again some way
// apart.
struct ScannedTop {
  TriangleMesh block = testing::block(26, 26, 12);
  ModelIndex model{block};
  std::vector<Point> cloud;
  CloudSurface surface;
  Overlap overlap;

  explicit ScannedTop(const Vec3& apart) {
    Random random(5);
    for (int i = 0; i < 29; ++i) {
      for (int j = 0; j < 29; ++j) {
        const double x = 6 + 0.5 * i + random.uniform(-0.1, 0.1);
        const double y = 6 + 0.5 * j + random.uniform(-0.1, 0.1);
        const double r = std::hypot(x - 13, y - 13);
        cloud.push_back({x, y, 12 + 3 * std::exp(-r * r / 6)});
      }
    }
    const std::size_t count = cloud.size();
    for (std::size_t k = 0; k < count; ++k) cloud.push_back(cloud[k] + apart);
    surface = cloud_surface(cloud);
    overlap = overlapping_facets(model, surface.rim);
  }
};

TEST(OutwardNormals, FaceAsTheModelDoes) {
  ScannedTop scene({0, 0, 0});  // each sample twice
  for (int turned = 0; turned < 2; ++turned) {
    const std::vector<Outward> normals =
        outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
    ASSERT_EQ(normals.size(), scene.cloud.size());
    std::size_t known = 0;
    for (const auto& [n, view] : normals) {
      if (n == Vec3{}) continue;
      ++known;
      EXPECT_EQ(view, Vec3{});
      EXPECT_GT(n.z, 0.3);
      EXPECT_NEAR(norm(n), 1, 1e-12);
    }
    EXPECT_GE(known, scene.cloud.size() / 2 - 20);
    EXPECT_LE(known, scene.cloud.size() / 2);
    for (Triangle& t : scene.surface.mesh.triangles) std::swap(t[1], t[2]);
  }
}

// A part without a loop on the model faces away from it where it hangs outside. Inside, as the
// floor of a pocket, it faces as the rim does: that is where the scan was seen from.
TEST(OutwardNormals, PartsWithoutALoopOnTheModelFaceAwayOrAsTheRimDoes) {
  for (const double apart : {20.0, -25.0, -6.0}) {
    const ScannedTop scene({0, 0, apart});
    const std::vector<Outward> normals =
        outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
    const auto is_known = [](const Outward& n) { return n.normal != Vec3{}; };
    const auto half = normals.begin() + static_cast<std::ptrdiff_t>(normals.size() / 2);
    EXPECT_GT(std::count_if(normals.begin(), half, is_known), 800) << apart;
    EXPECT_GT(std::count_if(half, normals.end(), is_known), 800) << apart;
    for (auto n = half; n != normals.end(); ++n) {
      if (is_known(*n)) {
        EXPECT_GT((apart == -25 ? -1 : 1) * n->normal.z, 0) << apart;
        EXPECT_EQ(n->is_presumed(), apart == -6) << apart;
      }
    }
  }
}

// Of the second half of the samples.
std::ptrdiff_t num_known_inside(const ScannedTop& scene) {
  const std::vector<Outward> normals =
      outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
  const auto half = normals.begin() + static_cast<std::ptrdiff_t>(normals.size() / 2);
  return std::count_if(half, normals.end(), [](const Outward& n) { return n.normal != Vec3{}; });
}

TriangleId facet_below(const ScannedTop& scene) {
  for (const TriangleId t : scene.block.triangles.ids()) {
    if (scene.model.normal(t).z < -0.9) return t;
  }
  return {};
}

// Where nobody knows from where the scan was seen the floor may face either way: the nearest side
// of the body may be the other one.
TEST(OutwardNormals, InsideNothingIsKnownIfTheRimDoesNotAgree) {
  ScannedTop scene({0, 0, -6});
  const std::vector<Outward> normals = outward_normals(scene.model, scene.cloud, scene.surface,
                                                       scene.overlap, {.min_agreement = 1.001});
  const auto half = normals.begin() + static_cast<std::ptrdiff_t>(normals.size() / 2);
  EXPECT_EQ(std::count(half, normals.end(), Outward{}), normals.end() - half);

  // The same loops on the lower side of the block: on the model they count as much, off it nothing.
  const std::vector<LoopOverlap> above = scene.overlap.loops;
  for (LoopOverlap below : above) {
    for (TriangleId& t : below.facets) t = facet_below(scene);
    scene.overlap.loops.push_back(below);
  }
  EXPECT_EQ(num_known_inside(scene), 0);
  for (std::size_t l = above.size(); l < scene.overlap.loops.size(); ++l) {
    scene.overlap.loops[l].match = LoopMatch::off_model;
  }
  EXPECT_GT(num_known_inside(scene), 800);
}

// A scan of the top, and one triangle turned over that touches it at a point of its rim. Whichever
// of the two comes last among the triangles, the other has its own way: the rim is that of the
// scan.
TEST(OutwardNormals, PartsThatTouchHaveEachTheirOwnWay) {
  for (const bool touching_first : {false, true}) {
    ScannedTop scene({0, 0, 0});
    CloudSurface& surface = scene.surface;
    const VertexId touched = surface.rim.loops[0].vertices[0];
    std::vector<VertexId> added;
    for (const double y : {0.0, 0.5}) {
      const Point away = surface.mesh.points[touched] + Vec3{-0.5, y, 0};
      surface.point_of_vertex.push_back(PointId(scene.cloud.size()));
      scene.cloud.push_back(away);
      added.push_back(surface.mesh.points.push_back(away));
    }
    Triangle turned = {touched, added[0], added[1]};
    const Vec3 normal = area_normal(surface.mesh.points[turned[0]], surface.mesh.points[turned[1]],
                                    surface.mesh.points[turned[2]]);
    if (normal.z > 0) std::swap(turned[1], turned[2]);
    if (touching_first) {
      surface.mesh.triangles.raw().insert(surface.mesh.triangles.raw().begin(), turned);
      for (TriangleId& t : surface.rim.loops[0].triangles) t = TriangleId(t.value + 1);
    } else {
      surface.mesh.triangles.push_back(turned);
    }
    const std::vector<Outward> normals =
        outward_normals(scene.model, scene.cloud, surface, scene.overlap);
    for (const VertexId v : added) {
      EXPECT_GT(normals[surface.point_of_vertex[v].index()].normal.z, 0.9) << touching_first;
    }
    EXPECT_GT(normals[surface.point_of_vertex[touched].index()].normal.z, 0.9) << touching_first;
  }
}

// Triangle by triangle, where they are not too steep.
TEST(OutwardNormals, AOneSidedPartFacesAsTheRimDoes) {
  ScannedTop scene({0, 0, 0});
  constexpr std::uint32_t steps = 60;
  const std::size_t of_band = scene.cloud.size();
  const auto first = static_cast<std::uint32_t>(scene.surface.mesh.points.size());
  for (std::uint32_t k = 0; k < steps; ++k) {
    const double angle = 2 * std::numbers::pi * k / steps;
    const Vec3 out = {std::cos(angle), std::sin(angle), 0};
    for (const double side : {-0.5, 0.5}) {  // turns over once
      const Vec3 across = std::cos(angle / 2) * out + Vec3{0, 0, std::sin(angle / 2)};
      scene.surface.point_of_vertex.push_back(PointId(scene.cloud.size()));
      scene.cloud.push_back(Point{13, 13, 20} + 5.0 * out + side * across);
      scene.surface.mesh.points.push_back(scene.cloud.back());
    }
  }
  for (std::uint32_t k = 0; k < steps; ++k) {
    const bool last = k + 1 == steps;
    const VertexId a(first + 2 * k);
    const VertexId b(first + 2 * k + 1);
    const VertexId c(first + (last ? 1 : 2 * k + 2));
    const VertexId d(first + (last ? 0 : 2 * k + 3));
    scene.surface.mesh.triangles.push_back({a, b, c});
    scene.surface.mesh.triangles.push_back({b, d, c});
  }
  const std::vector<Outward> normals =
      outward_normals(scene.model, scene.cloud, scene.surface, scene.overlap);
  std::size_t known = 0;
  for (std::size_t k = of_band; k < normals.size(); ++k) {
    if (normals[k].normal == Vec3{}) continue;
    ++known;
    EXPECT_GT(normals[k].normal.z, 0.2);
    EXPECT_NEAR(normals[k].view.z, 1, 1e-9);
  }
  EXPECT_GT(known, steps);
  EXPECT_LT(known, 2 * steps);
}

}  // namespace
}  // namespace cocoon
