// The local update as a whole, on shapes whose updated surface is known.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/surface_distance.h"
#include "io/sample_models.h"
#include "tests/end_to_end/local_update.h"
#include "tests/gallery.h"
#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"
#include "update/model/model_index.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using std::numbers::pi;
using testing::cap_with_hill;
using testing::Clouds;
using testing::expect_local_update;
using testing::hill;
using testing::polar_angle;
using testing::sphere_points;

TriangleMesh sphere_model(std::size_t n) {
  const ReconstructResult result = reconstruct_tight(sphere_points(n));
  EXPECT_EQ(result.status, SurfaceStatus::ok);
  return result.mesh;
}

// The cap of polar angle `polar` about `axis`, raised by a hill of the given height in its inner
// two thirds; n is the number of points the whole sphere would have.
std::vector<Point> raised_cap(std::size_t n, const Vec3& axis, double polar, double height) {
  std::vector<Point> cap;
  for (const Point& p : sphere_points(n, 7)) {
    const double angle = polar_angle(p, axis);
    if (angle <= polar) cap.push_back((1 + height * hill(angle, polar * 2 / 3)) * p);
  }
  return cap;
}

// The largest deviation of the corners and centroids of triangles from a star-shaped surface.
double largest_deviation(const TriangleMesh& mesh,
                         const std::function<double(const Point&)>& radius) {
  double largest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point center = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
    for (const Point& p : {mesh.points[a], center}) {
      largest = std::max(largest, std::abs(norm(p) - radius(unit(p))));
    }
  }
  return largest;
}

constexpr std::size_t sphere_size = 3000;  // spacing 0.065

TEST(UpdateScenarios, SphereByACap) {
  const TriangleMesh model = sphere_model(sphere_size);
  const Vec3 axis = unit(Vec3{1, 2, 2});
  const double polar = 0.6;
  const Clouds clouds = {raised_cap(4 * sphere_size, axis, polar, 0.25)};
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return polar_angle(p, axis) < polar - 0.08; },
      [&](const Point& p) { return polar_angle(p, axis) > polar + 0.02; });
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_EQ(result.regions.regions.size(), 2U);
  EXPECT_EQ(result.replaced_groups.size(), 1U);
  ASSERT_EQ(result.clouds[0].groups.size(), 2U);
  EXPECT_GT(result.clouds[0].margin_deg, 150);
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
  EXPECT_LT(largest_deviation(result.mesh,
                              [&](const Point& p) {
                                return 1 + 0.25 * hill(polar_angle(p, axis), polar * 2 / 3);
                              }),
            0.01);
}

// A dent and a hill far from each other.
TEST(UpdateScenarios, SphereByTwoCaps) {
  const TriangleMesh model = sphere_model(sphere_size);
  const Vec3 north = {0, 0, 1};
  const Vec3 side = {1, 0, 0};
  const Clouds clouds = {raised_cap(3 * sphere_size, north, 0.5, -0.2),
                         raised_cap(5 * sphere_size, side, 0.6, 0.3)};
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result,
      [&](const Point& p) { return polar_angle(p, north) < 0.4 || polar_angle(p, side) < 0.5; },
      [&](const Point& p) { return polar_angle(p, north) > 0.53 && polar_angle(p, side) > 0.63; });
  EXPECT_EQ(result.regions.regions.size(), 3U);
  EXPECT_EQ(result.replaced_groups.size(), 2U);
  for (const CloudReport& cloud : result.clouds) EXPECT_EQ(cloud.replaced_groups.size(), 1U);
  EXPECT_LT(largest_deviation(result.mesh,
                              [&](const Point& p) {
                                return 1 - 0.2 * hill(polar_angle(p, north), 0.5 * 2 / 3) +
                                       0.3 * hill(polar_angle(p, side), 0.4);
                              }),
            0.012);
}

// The order of clouds and of points only numbers things.
TEST(UpdateScenarios, OrderDoesNotMatter) {
  const TriangleMesh model = sphere_model(1500);
  Clouds clouds = {raised_cap(4500, {0, 0, 1}, 0.5, -0.2), raised_cap(6000, {1, 0, 0}, 0.6, 0.3)};
  const UpdateResult expected = update_model(model, clouds);
  auto sorted_triangles = [](const TriangleMesh& mesh) {
    std::vector<std::array<Point, 3>> triangles;
    for (const Triangle& t : mesh.triangles) {
      std::array<Point, 3> corners = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  Random random(5);
  random.shuffle(clouds[0]);
  random.shuffle(clouds[1]);
  std::swap(clouds[0], clouds[1]);
  const UpdateResult shuffled = update_model(model, clouds, {}, {.threads = 3});
  EXPECT_EQ(shuffled.replacement.vertices.replaced, expected.replacement.vertices.replaced);
  EXPECT_EQ(sorted_triangles(shuffled.mesh), sorted_triangles(expected.mesh));
}

// Two scans that overlap each other where the shape is new: the rim of each ends in the other one.
TEST(UpdateScenarios, SphereByTwoHalvesOfOneCap) {
  const TriangleMesh model = sphere_model(sphere_size);
  const Vec3 north = {0, 0, 1};
  const std::vector<Point> cap = raised_cap(4 * sphere_size, north, 0.8, 0.5);
  Clouds clouds(2);
  for (const Point& p : cap) {
    if (p.x < 0.15) clouds[0].push_back(p);
    if (p.x > -0.15) clouds[1].push_back(p);
  }
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return polar_angle(p, north) < 0.7; },
      [&](const Point& p) { return polar_angle(p, north) > 0.83; });
  EXPECT_GT(result.replacement.duplicates, 50U);
  EXPECT_EQ(result.clouds[1].joined_with, 0U);
  EXPECT_LT(largest_deviation(
                result.mesh,
                [&](const Point& p) { return 1 + 0.5 * hill(polar_angle(p, north), 0.8 * 2 / 3); }),
            0.02);
}

// A ring is replaced, what it surrounds is kept.
TEST(UpdateScenarios, SphereByAnAnnulus) {
  const TriangleMesh model = sphere_model(sphere_size);
  const Vec3 axis = {0, 0, 1};
  Clouds clouds(1);
  auto ridge = [&](const Point& p) {
    return 0.1 * hill(std::abs(polar_angle(p, axis) - 0.9), 0.3);
  };
  for (const Point& p : sphere_points(4 * sphere_size, 3)) {
    if (std::abs(polar_angle(p, axis) - 0.9) < 0.5) clouds[0].push_back((1 + ridge(p)) * p);
  }
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result,
      [&](const Point& p) { return std::abs(polar_angle(p, axis) - 0.9) < 0.42; },
      [&](const Point& p) { return std::abs(polar_angle(p, axis) - 0.9) > 0.53; });
  EXPECT_EQ(result.clouds[0].loops.size(), 2U);
  EXPECT_EQ(result.regions.regions.size(), 3U);
  EXPECT_EQ(result.replaced_groups.size(), 1U);
  EXPECT_LT(largest_deviation(result.mesh, [&](const Point& p) { return 1 + ridge(p); }), 0.01);
}

// The top of a block with flat sides and sharp edges gets a hill.
TEST(UpdateScenarios, BlockByACap) {
  const TriangleMesh model = testing::block(24, 20, 8);
  const Clouds clouds = {cap_with_hill({12, 10, 8}, 3)};
  auto off_axis = [](const Point& p) { return std::hypot(p.x - 12, p.y - 10); };
  // Tight Cocone cuts off a sharp corner of three faces if that is one sample.
  auto is_corner = [](const Point& p) {
    return (p.x == 0 || p.x == 24) && (p.y == 0 || p.y == 20) && (p.z == 0 || p.z == 8);
  };
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return p.z == 8 && off_axis(p) < 7; },
      [&](const Point& p) { return off_axis(p) > 8.2 && !is_corner(p); });
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const Point p = (result.mesh.points[a] + result.mesh.points[b] + result.mesh.points[c]) / 3;
    if (p.z < 7.5 || off_axis(p) > 9.5) continue;
    EXPECT_NEAR(p.z, 8 + 3 * hill(off_axis(p), 6), 0.2);
  }
}

// The test block of the paper, at its size.
TEST(UpdateScenarios, SampleBlock) {
  const SampleModel sample = sample_model("block");
  const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
  const UpdateResult result = update_model(model, sample.clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  ASSERT_EQ(result.replaced_groups.size(), 1U);
  // All that the change makes wrong is replaced; what is replaced beyond it lies under the cloud.
  for (const PointId p : sample.replaced) {
    for (const VertexId v : model.points.ids()) {
      if (model.points[v] != sample.initial[p.index()]) continue;
      EXPECT_TRUE(result.vertex_map[v].is_none()) << p.value;
    }
  }
  EXPECT_LT(result.replacement.vertices.replaced, sample.replaced.size() * 3 / 2);
  const SurfaceDistance distance = surface_distance(result.mesh, sample.truth, {.samples = 20000});
  EXPECT_LT(distance.mean, 0.01);
  EXPECT_LT(distance.max, 0.1);
}

TEST(UpdateScenarios, DisplacedCloud) {
  const TriangleMesh model = sphere_model(sphere_size);
  Clouds clouds = {raised_cap(2 * sphere_size, {0, 0, 1}, 0.6, 0.2)};
  for (Point& p : clouds[0]) p.z += 0.5;
  const UpdateResult result = update_model(model, clouds);
  EXPECT_EQ(result.status, UpdateStatus::no_overlap);
  EXPECT_NE(result.message.find("cloud 1"), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("register it"), std::string::npos) << result.message;
  EXPECT_EQ(result.message.find('\n'), std::string::npos);
  EXPECT_TRUE(result.mesh.triangles.empty());
}

TEST(UpdateScenarios, CloudInOtherUnits) {
  const TriangleMesh model = sphere_model(sphere_size);
  for (const auto& [factor, told] : {std::pair(0.001, "by 1000 it would lie there"),
                                     {1000, "by 0.001 it would lie there"},
                                     {25.4, "by 0.03937 it would lie there"},
                                     {0.1, "by 10 it would lie there"}}) {
    const Clouds clouds = {
        gallery::scaled(raised_cap(2 * sphere_size, {0, 0, 1}, 0.6, 0.2), factor)};
    const UpdateResult result = update_model(model, clouds);
    EXPECT_EQ(result.status, UpdateStatus::no_overlap);
    EXPECT_NE(result.message.find(told), std::string::npos) << result.message;
  }
}

TEST(UpdateScenarios, ClosedCloud) {
  const TriangleMesh model = sphere_model(sphere_size);
  Clouds clouds(1);
  for (const Point& p : sphere_points(2000, 4)) clouds[0].push_back(0.4 * p + Vec3{0.8, 0, 0});
  const UpdateResult result = update_model(model, clouds);
  EXPECT_EQ(result.status, UpdateStatus::cloud_closed);
  EXPECT_NE(result.message.find("no open rim"), std::string::npos) << result.message;
}

constexpr double tube = 0.4;

TriangleMesh torus_model() {
  std::vector<Point> points;
  Random random(2);
  for (int i = 0; i < 120; ++i) {
    for (int j = 0; j < 48; ++j) {
      points.push_back(testing::torus_point(2 * pi * (i + 0.3 * random.uniform()) / 120,
                                            2 * pi * (j + 0.3 * random.uniform()) / 48, tube));
    }
  }
  const ReconstructResult result = reconstruct_tight(points);
  EXPECT_EQ(mesh_check(result.mesh).euler, 0);
  return result.mesh;
}

// A bowl across the tube of the torus: its rim runs around the tube and does not cut the torus.
TEST(UpdateScenarios, TorusByAMembrane) {
  const TriangleMesh model = torus_model();
  Clouds clouds(1);
  Random random(6);
  for (double r = 0; r <= 1; r += 0.05) {
    const int n = std::max(1, static_cast<int>(2 * pi * r / 0.05));
    for (int k = 0; k < n; ++k) {
      const double v = 2 * pi * (k + 0.2 * random.uniform()) / n;
      clouds[0].push_back(testing::torus_point(0.3 * (1 - r * r), v, tube * r));
    }
  }
  const UpdateResult result = update_model(model, clouds);
  EXPECT_EQ(result.status, UpdateStatus::non_separating) << result.message;
  EXPECT_NE(result.message.find("handle"), std::string::npos) << result.message;
}

// A sleeve around the tube has two rims. Neither cuts the torus alone, both together do.
TEST(UpdateScenarios, TorusByASleeve) {
  const TriangleMesh model = torus_model();
  Clouds clouds(1);
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j < 80; ++j) {
      const double u = i / 40.0;
      clouds[0].push_back(testing::torus_point(u, 2 * pi * (j + 0.5 * (i % 2)) / 80,
                                               tube * (1 + 0.2 * hill(std::abs(u - 0.5), 0.4))));
    }
  }
  const UpdateResult result = update_model(model, clouds);
  const auto u_of = [](const Point& p) { return std::atan2(p.y, p.x); };
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return u_of(p) > 0.06 && u_of(p) < 0.94; },
      [&](const Point& p) { return u_of(p) < -0.06 || u_of(p) > 1.06; });
  EXPECT_EQ(mesh_check(result.mesh).euler, 0);
  EXPECT_EQ(result.clouds[0].loops.size(), 2U);
}

// A cloud much smaller than a facet: there is nothing to replace, it is added.
TEST(UpdateScenarios, CloudWithinOneFacet) {
  const TriangleMesh model = sphere_model(200);
  const Point center = unit((model.points[model.triangles[TriangleId(50)][0]] +
                             model.points[model.triangles[TriangleId(50)][1]] +
                             model.points[model.triangles[TriangleId(50)][2]]) /
                            3);
  const Clouds clouds = {raised_cap(200000, center, 0.03, 0.003)};
  ASSERT_GT(clouds[0].size(), 30U);
  const UpdateResult result = update_model(model, clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.replacement.vertices.replaced, 0U);
  EXPECT_EQ(result.clouds[0].loops[0].separation, Separation::encloses_nothing);
  EXPECT_FALSE(result.warnings.empty());
}

// Of a regular grid the rim leaves out samples at two corners. Even if that counts as a seam,
// nothing of the border is missing for it on a facet as large as this one.
TEST(UpdateScenarios, GridWithinOneFacet) {
  const TriangleMesh model = gallery::tetrahedron();
  const auto [a, b, c] = corners_of(model, TriangleId(0));
  const Vec3 along = unit(b - a);
  const Vec3 across = unit((c - a) - dot(c - a, along) * along);
  const Vec3 up = cross(along, across);
  const double step = 0.01 * distance(a, b);
  Clouds clouds(1);
  for (int i = -8; i < 8; ++i) {
    for (int k = -8; k < 8; ++k) {
      const double height = std::max(0.0, 1 - (i * i + k * k) / 30.0);
      clouds[0].push_back((a + b + c) / 3 + step * (i * along + k * across + 2 * height * up));
    }
  }
  for (const std::size_t min_samples : {std::size_t{1}, std::size_t{2}}) {
    UpdateOptions options;
    options.cloud.seams.min_samples = min_samples;
    const UpdateResult result = update_model(model, clouds, options);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_EQ(result.clouds[0].surface.rim.is_partial(), min_samples == 1);
    EXPECT_EQ(result.replacement.vertices.replaced, 0U);
    EXPECT_EQ(result.clouds[0].loops[0].separation, Separation::encloses_nothing);
    EXPECT_EQ(result.mesh.points.size(), 4 + clouds[0].size());
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  }
}

// So is one close to a corner of the facet: the corner stays.
TEST(UpdateScenarios, CloudWithinOneFacetBesideACorner) {
  const TriangleMesh model = sphere_model(200);
  for (std::size_t t = 0; t < 100; t += 10) {
    const Triangle& corners = model.triangles[TriangleId(t)];
    const Point& corner = model.points[corners[0]];
    const Point middle = (corner + model.points[corners[1]] + model.points[corners[2]]) / 3;
    const Clouds clouds = {
        raised_cap(400000, unit(corner + 0.35 * (middle - corner)), 0.02, 0.002)};
    const UpdateResult result = update_model(model, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_EQ(result.replacement.vertices.replaced, 0U) << t;
  }
}

// A cloud with a hole whose rim lies on the new shape, off the old model: the hole is no border.
TEST(UpdateScenarios, CloudWithAHoleOnTheNewShape) {
  const TriangleMesh model = sphere_model(sphere_size);
  const Vec3 axis = {0, 1, 0};
  Clouds clouds(1);
  for (const Point& p : raised_cap(4 * sphere_size, axis, 0.8, 0.8)) {
    if (polar_angle(p, axis) > 0.14) clouds[0].push_back(p);
  }
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return polar_angle(p, axis) < 0.7; },
      [&](const Point& p) { return polar_angle(p, axis) > 0.83; });
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  ASSERT_EQ(result.clouds[0].loops.size(), 2U);
}

// Two sheets close together: the cloud lies on one of them, two spacings away from the other.
TEST(UpdateScenarios, ThinPlateByACap) {
  const TriangleMesh model = testing::block(24, 20, 2);
  const Clouds clouds = {cap_with_hill({12, 10, 2}, 3)};
  const auto off_axis = [](const Point& p) { return std::hypot(p.x - 12, p.y - 10); };
  const auto is_corner = [](const Point& p) {
    return (p.x == 0 || p.x == 24) && (p.y == 0 || p.y == 20) && (p.z == 0 || p.z == 2);
  };
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return p.z == 2 && off_axis(p) < 7; },
      [&](const Point& p) { return (p.z < 2 || off_axis(p) > 8.2) && !is_corner(p); });
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
}

// Bodies that no rim touches stay as they are.
TEST(UpdateScenarios, OtherBodiesAreKept) {
  std::vector<Point> points = sphere_points(sphere_size);
  for (const Point& p : sphere_points(1000, 5)) points.push_back(0.5 * p + Vec3{3, 0, 0});
  const TriangleMesh model = reconstruct_tight(points).mesh;
  ASSERT_EQ(mesh_check(model).components, 2U);
  const Clouds clouds = {raised_cap(4 * sphere_size, {0, 0, 1}, 0.6, 0.25)};
  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result,
      [&](const Point& p) {
        return p.x < 2 && polar_angle(p, {0, 0, 1}) < 0.52;
      },
      [&](const Point& p) {
        return p.x > 2 || polar_angle(p, {0, 0, 1}) > 0.62;
      });
  EXPECT_EQ(mesh_check(result.mesh).components, 2U);
  EXPECT_EQ(result.replaced_groups.size(), 1U);
}

TEST(UpdateScenarios, CallerMistakes) {
  const TriangleMesh model = sphere_model(300);
  EXPECT_THROW(update_model(model, Clouds{}), InputError);
  EXPECT_THROW(update_model(model, Clouds{{}}), InputError);
  EXPECT_THROW(update_model({}, Clouds{raised_cap(3000, {0, 0, 1}, 0.6, 0.2)}), InputError);
  const Clouds line = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
  try {
    update_model(model, line);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cloud 1 of 1"), std::string::npos) << error.what();
  }
}

struct Steps : Progress {
  std::vector<std::string> finished;
  bool report(std::string_view stage, double fraction) override {
    if (fraction == 1 && stage.find('/') == std::string_view::npos) finished.emplace_back(stage);
    return true;
  }
};

TEST(UpdateScenarios, ReportsTheFourStepsOfThePaper) {
  const TriangleMesh model = sphere_model(1000);
  const Clouds clouds = {raised_cap(4000, {0, 0, 1}, 0.6, 0.2)};
  Steps steps;
  update_model(model, clouds, {}, {.threads = 1, .progress = &steps});
  EXPECT_EQ(steps.finished,
            (std::vector<std::string>{"boundary_detection", "overlapping_facets",
                                      "segmentation_and_selection", "reconstruction"}));
}

}  // namespace
}  // namespace cocoon
