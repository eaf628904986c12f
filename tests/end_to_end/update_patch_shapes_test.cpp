// Clouds of other outlines than disks: an L, around an edge and a corner of a block, a ring around
// a hole, the two ends of a cylinder.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "tests/end_to_end/boxy_part.h"
#include "tests/end_to_end/local_update.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using std::numbers::pi;
using testing::Clouds;
using testing::expect_local_update;
using testing::hill;
using testing::Predicate;

// Tight Cocone cuts off a sharp corner of three faces if that is one sample.
bool is_corner(const Point& p, const Point& size) {
  return (p.x == 0 || p.x == size.x) && (p.y == 0 || p.y == size.y) && (p.z == 0 || p.z == size.z);
}

// Samples half a unit apart on the faces x = 0, y = 0 and z = 0 of the octant up to `reach`, each
// moved a little within its face.
std::vector<Point> octant_faces(const Point& reach) {
  Random random(4);
  std::vector<Point> points;
  for (int i = 0; i <= 2 * reach.x; ++i) {
    for (int j = 0; j <= 2 * reach.y; ++j) {
      for (int k = 0; k <= 2 * reach.z; ++k) {
        if (i * j * k > 0) continue;
        Point p = {0.5 * i, 0.5 * j, 0.5 * k};
        for (double* x : {&p.x, &p.y, &p.z}) *x += *x == 0 ? 0 : random.uniform(-0.1, 0.1);
        points.push_back(p);
      }
    }
  }
  return points;
}

// The top face of the block, with a height.
template <class Height>
std::vector<Point> top_samples(const Predicate& wanted, const Height& height) {
  std::vector<Point> samples;
  for (const Point& p : octant_faces({24, 20, 0})) {
    if (wanted(p)) samples.push_back({p.x, p.y, 8 + height(p)});
  }
  return samples;
}

constexpr Point size = {24, 20, 8};

// How far inside an L of two arms, each 6 wide, a place is: below 0 outside.
double depth_in_l(const Point& p) {
  const auto in_box = [&p](double x, double y) {
    return std::min({p.x - 3, x - p.x, p.y - 3, y - p.y});
  };
  return std::max(in_box(9, 17), in_box(21, 9));
}

// A ridge along both arms. The inner corner of the L stays: its hull is not the cloud.
TEST(UpdatePatchShapes, AnLOnAFace) {
  const TriangleMesh model = testing::block(24, 20, 8);
  const auto height = [](const Point& p) { return hill(3 - std::max(depth_in_l(p), 0.0), 2); };
  const Clouds clouds = {top_samples([](const Point& p) { return depth_in_l(p) > 0; }, height)};
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [](const Point& p) { return p.z == 8 && depth_in_l(p) > 0.8; },
      [](const Point& p) { return (p.z < 8 || depth_in_l(p) < -0.2) && !is_corner(p, size); });
  EXPECT_EQ(result.clouds[0].loops.size(), 1U);
  EXPECT_EQ(result.regions.regions.size(), 2U);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const Point p = (result.mesh.points[a] + result.mesh.points[b] + result.mesh.points[c]) / 3;
    if (p.z > 7.5 && depth_in_l(p) > 0.5) {
      EXPECT_NEAR(p.z, 8 + height(p), 0.3);
    }
  }
}

// The middle of the edge between the top and a side is cut off, as deep as a hill: the cloud runs
// around the edge, and the edge is cut where the cloud begins and ends.
TEST(UpdatePatchShapes, AroundAnEdge) {
  const TriangleMesh model = testing::block(24, 20, 8);
  Clouds clouds(1);
  for (const Point& p : octant_faces({7, 13, 5})) {
    if (p.y == 0 && p.x * p.z > 0) continue;
    Point q = {24 - p.x, 3.5 + p.y, 8 - p.z};
    const double over = 3 * hill(std::abs(q.y - 10), 5) - p.x - p.z;
    if (over > 0) q = q - over / 2 * Vec3{1, 0, 1};
    clouds[0].push_back(q);
  }
  const UpdateResult result = update_model(model, clouds);
  const auto depth = [](const Point& p) {
    return std::min({p.x - 17, p.y - 3.5, 16.5 - p.y, p.z - 3});
  };
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return depth(p) > 0.8; },
      [&](const Point& p) { return depth(p) < -0.2 && !is_corner(p, size); });
  EXPECT_EQ(result.regions.regions.size(), 2U);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
}

// A corner of three faces is cut off: of the volume 6^3 / 6 is missing.
TEST(UpdatePatchShapes, AroundACorner) {
  const Point corner = {24, 20, 12};
  const TriangleMesh model = testing::block(24, 20, 12);
  Clouds clouds(1);
  for (const Point& p : octant_faces({8, 8, 8})) {
    const double over = std::max(0.0, 6 - p.x - p.y - p.z) / 3;
    clouds[0].push_back(corner - p - over * Vec3{1, 1, 1});
  }
  const UpdateResult result = update_model(model, clouds);
  const auto depth = [&](const Point& p) {
    return 8 - std::max({corner.x - p.x, corner.y - p.y, corner.z - p.z});
  };
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return depth(p) > 0.8; },
      [&](const Point& p) { return depth(p) < -0.2 && !is_corner(p, corner); });
  EXPECT_EQ(result.regions.regions.size(), 2U);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_NEAR(mesh_measure(result.mesh).signed_volume, 24 * 20 * 12 - 36, 4);
}

// The ring around the mouth of a hole through the block gets a ridge. The mouth stays: it hangs
// together with what is outside of the ring, through the hole.
TEST(UpdatePatchShapes, ARingAroundAHole) {
  const auto from_axis = [](const Point& p) { return std::hypot(p.x - 12, p.y - 10); };
  const TriangleMesh model = testing::surface_of(
      {{24, 20, 8}, [](int x, int y, int) { return x < 10 || x >= 14 || y < 8 || y >= 12; }});
  ASSERT_EQ(mesh_check(model).euler, 0);
  const Clouds clouds = {
      top_samples([&](const Point& p) { return from_axis(p) > 4 && from_axis(p) < 8.5; },
                  [&](const Point& p) { return hill(std::abs(from_axis(p) - 6.3), 1.6); })};
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result,
      [&](const Point& p) { return p.z == 8 && from_axis(p) > 4.8 && from_axis(p) < 7.7; },
      [&](const Point& p) {
        return (p.z < 8 || from_axis(p) < 3.8 || from_axis(p) > 8.7) && !is_corner(p, size);
      });
  EXPECT_EQ(result.clouds[0].loops.size(), 2U);
  EXPECT_EQ(result.regions.regions.size(), 2U);
  EXPECT_EQ(result.replaced_groups.size(), 1U);
  const MeshReport check = mesh_check(result.mesh);
  EXPECT_EQ(check.euler, 0);
  EXPECT_EQ(check.components, 1U);
}

constexpr double radius = 6;
constexpr double height = 16;

// A ring of samples about the z-axis, about `spacing` apart.
void add_ring(double r, double z, double spacing, Random& random, std::vector<Point>& points) {
  const int n = std::max(1, static_cast<int>(std::round(2 * pi * r / spacing)));
  const double start = random.uniform();
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * pi * (k + start + random.uniform(-0.1, 0.1)) / n;
    points.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
}

// An end of the cylinder with `wall` of its wall, hollowed out as deep as `dent` in its middle.
std::vector<Point> cylinder_end(double wall, double dent, double spacing, Random& random) {
  std::vector<Point> points;
  for (double z = spacing; z <= wall; z += spacing) add_ring(radius, z, spacing, random, points);
  const int rings = static_cast<int>(std::round(radius / spacing));
  for (int ring = 0; ring <= rings; ++ring) {
    const double r = radius * ring / rings;
    add_ring(r, dent * hill(r, 5), spacing, random, points);
  }
  return points;
}

Point mirrored(const Point& p) { return {p.x, p.y, height - p.z}; }

// One end gets a boss, the other one a dent. The wall between them stays.
TEST(UpdatePatchShapes, TheTwoEndsOfACylinder) {
  Random random(3);
  std::vector<Point> samples = cylinder_end(height - 0.7, 0, 0.7, random);
  for (const Point& p : cylinder_end(0, 0, 0.7, random)) samples.push_back(mirrored(p));
  const TriangleMesh model = reconstruct_tight(samples).mesh;
  ASSERT_TRUE(mesh_check(model).is_closed_manifold());
  Clouds clouds = {cylinder_end(4, -1.5, 0.4, random), cylinder_end(4, 1.5, 0.4, random)};
  for (Point& p : clouds[1]) p = mirrored(p);
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result,
      [](const Point& p) { return std::abs(p.z - height / 2) > height / 2 - 3; },
      [](const Point& p) { return std::abs(p.z - height / 2) < height / 2 - 4.2; });
  EXPECT_EQ(result.regions.regions.size(), 3U);
  EXPECT_EQ(result.replaced_groups.size(), 2U);
  for (const CloudReport& cloud : result.clouds) {
    EXPECT_EQ(cloud.loops.size(), 1U);
    EXPECT_EQ(cloud.replaced_groups.size(), 1U);
  }
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_EQ(mesh_check(result.mesh).components, 1U);
  // The boss is as large as the dent.
  EXPECT_NEAR(mesh_measure(result.mesh).signed_volume, pi * radius * radius * height, 12);
}

}  // namespace
}  // namespace cocoon
