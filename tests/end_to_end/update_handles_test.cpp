// Updates of models with handles that keep a rim from cutting the model in two.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/end_to_end/boxy_part.h"
#include "tests/end_to_end/local_update.h"
#include "tests/gallery.h"
#include "tests/update/hand_made_models.h"
#include "update/model/euler_number.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::cap_with_hill;
using testing::Clouds;
using testing::hill;

// The block of 24 * 20 * 8 with a square hole of size 4 through it, top to bottom, in its middle.
TriangleMesh block_with_a_hole() {
  TriangleMesh mesh = testing::block(24, 20, 8);
  const auto is_in_mouth = [&](VertexId v) {
    const Point& p = mesh.points[v];
    return (p.z == 0 || p.z == 8) && p.x >= 10 && p.x <= 14 && p.y >= 8 && p.y <= 12;
  };
  IdVector<TriangleId, Triangle> left;
  for (const Triangle& t : mesh.triangles) {
    if (!std::all_of(t.begin(), t.end(), is_in_mouth)) left.push_back(t);
  }
  mesh.triangles = left;
  std::map<Point, VertexId> vertex_at;
  for (const VertexId v : mesh.points.ids()) vertex_at[mesh.points[v]] = v;
  const auto at = [&](double x, double y, double z) {
    const auto [entry, is_new] = vertex_at.try_emplace({x, y, z});
    if (is_new) entry->second = mesh.points.push_back({x, y, z});
    return entry->second;
  };
  // Counterclockwise around the hole, seen from above: the wall faces the axis.
  std::vector<std::array<double, 2>> around;
  for (int k = 0; k < 4; ++k) around.push_back({10.0 + k, 8});
  for (int k = 0; k < 4; ++k) around.push_back({14, 8.0 + k});
  for (int k = 0; k < 4; ++k) around.push_back({14.0 - k, 12});
  for (int k = 0; k < 4; ++k) around.push_back({10, 12.0 - k});
  for (std::size_t k = 0; k < around.size(); ++k) {
    const auto [x, y] = around[k];
    const auto [u, v] = around[(k + 1) % around.size()];
    for (int z = 0; z < 8; ++z) {
      mesh.triangles.push_back({at(x, y, z), at(x, y, z + 1), at(u, v, z + 1)});
      mesh.triangles.push_back({at(x, y, z), at(u, v, z + 1), at(u, v, z)});
    }
  }
  return mesh;
}

std::ptrdiff_t warnings_with(const UpdateResult& result, const std::string& words) {
  return std::count_if(
      result.warnings.begin(), result.warnings.end(),
      [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

// The way through the hole leads from inside the rim to outside of it, on the far side of the
// block. The mouth is under the hill, and goes; the rest of the hole stays, as a blind one.
TEST(UpdateWithHandles, BlockWithAHoleByACap) {
  const TriangleMesh model = block_with_a_hole();
  ASSERT_TRUE(mesh_check(model).is_closed_manifold());
  ASSERT_EQ(mesh_check(model).euler, 0);
  const UpdateResult result = update_model(model, Clouds{cap_with_hill({12, 10, 8}, 3)});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.clouds[0].loops[0].separation, Separation::non_separating);
  EXPECT_EQ(warnings_with(result, "does not cut the model in two"), 1);
  for (const VertexId v : model.points.ids()) {
    const Point& p = model.points[v];
    const double r = std::hypot(p.x - 12, p.y - 10);
    if (std::abs(p.x - 12) < 2 && std::abs(p.y - 10) < 2) continue;  // of no triangle
    const bool gone = result.replacement.point_of_vertex[v].is_none();
    if (p.z == 8 && r < 7) {
      EXPECT_TRUE(gone) << p.x << ' ' << p.y;
    }
    if (p.z < 7 || r > 9) {
      EXPECT_FALSE(gone) << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
  const MeshReport check = mesh_check(result.mesh);
  EXPECT_TRUE(check.is_closed_manifold());
  EXPECT_EQ(check.euler, 2);

  UpdateOptions near;
  near.cut.box_reach = 0;
  const UpdateResult refused = update_model(model, Clouds{cap_with_hill({12, 10, 8}, 3)}, near);
  EXPECT_EQ(refused.status, UpdateStatus::non_separating);
  EXPECT_NE(refused.message.find("no short cut across"), std::string::npos) << refused.message;
  EXPECT_TRUE(refused.mesh.triangles.empty());
}

// A slot in the top of a block that is closed in its middle, under the rim: a tunnel from inside
// the rim to outside of it. It is cut where it is narrowest.
TEST(UpdateWithHandles, BlockWithAClosedSlotByACap) {
  const TriangleMesh model =
      testing::surface_of({{24, 36, 10}, [](int x, int y, int z) {
                             const bool in_slot = x >= 10 && x < 14 && y >= 13 && y < 27 && z >= 5;
                             const bool in_bridge = y >= 17 && y < 23 && z >= 8;
                             return !in_slot || in_bridge;
                           }});
  ASSERT_TRUE(mesh_check(model).is_closed_manifold());
  ASSERT_EQ(mesh_check(model).euler, 0);
  const Point center = {12, 12, 10};
  const UpdateResult result = update_model(model, Clouds{cap_with_hill(center, 1)});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.clouds[0].loops[0].separation, Separation::non_separating);
  EXPECT_EQ(result.regions.regions.size(), 2U);
  EXPECT_EQ(result.replaced_groups.size(), 1U);
  EXPECT_EQ(warnings_with(result, "does not cut the model in two"), 1);
  // Nearly all the model has to stay; of the top and the tunnel the rim decides.
  for (const VertexId v : model.points.ids()) {
    const Point& p = model.points[v];
    const double r = std::hypot(p.x - center.x, p.y - center.y);
    const bool in_tunnel = p.x >= 10 && p.x <= 14 && p.y >= 13 && p.y <= 27 && p.z >= 5;
    const bool gone = result.replacement.point_of_vertex[v].is_none();
    const bool must_go = (p.z == 10 && r < 7) || (in_tunnel && p.y < 18);
    const bool must_stay =
        (p.z == 10 && r > 9) || (in_tunnel && p.y > 22) || (p.z < 10 && !in_tunnel);
    EXPECT_FALSE(must_go && !gone) << "left over: " << p.x << ' ' << p.y << ' ' << p.z;
    EXPECT_FALSE(must_stay && gone) << "lost: " << p.x << ' ' << p.y << ' ' << p.z;
  }
  const MeshReport check = mesh_check(result.mesh);
  EXPECT_EQ(check.open_edges, 0U);
  EXPECT_TRUE(check.is_closed_manifold());
  EXPECT_EQ(check.euler, 2);  // the tunnel is a dead end
}

// A piece of the tube of a torus with radii 1 and 0.35, through which a hole is drilled that no rim
// tells of.
std::vector<Point> drilled_tube(double spacing) {
  constexpr double tube = 0.35;
  constexpr double hole = 0.16;
  std::vector<Point> samples;
  const int rows = static_cast<int>(2 * std::numbers::pi * tube / spacing);
  for (int i = 0; spacing * i < 1.8; ++i) {
    for (int k = 0; k < rows; ++k) {
      const double v = 2 * std::numbers::pi * (k + 0.5 * (i % 2)) / rows;
      const Point p = testing::torus_point(spacing * i - 0.9, v, tube);
      if (std::hypot(p.x - 1, p.y) > hole + 0.3 * spacing) samples.push_back(p);
    }
  }
  const int around = static_cast<int>(2 * std::numbers::pi * hole / spacing);
  for (int k = 0; k < around; ++k) {
    const double u = 2 * std::numbers::pi * k / around;
    const double x = 1 + hole * std::cos(u);
    const double y = hole * std::sin(u);
    const double height = std::sqrt(tube * tube - (std::hypot(x, y) - 1) * (std::hypot(x, y) - 1));
    const int steps = static_cast<int>(std::ceil(2 * height / spacing));
    for (int j = 0; j <= steps; ++j) samples.push_back({x, y, height * (2.0 * j / steps - 1)});
  }
  return samples;
}

// Two rims, but one part of the model between them: of a handle neither tells, but the samples show
// it.
TEST(UpdateWithHandles, AHandleOfATubeInThePlaceOfATubeIsOfTheSamples) {
  const TriangleMesh model = testing::torus(126, 44, 0.35);
  const UpdateResult result = update_model(model, Clouds{drilled_tube(0.045)});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.clouds[0].loops.size(), 2U);
  EXPECT_EQ(result.replaced_groups.size(), 1U);
  EXPECT_EQ(mesh_check(result.mesh).euler, -2);
  EXPECT_EQ(result.unexplained_handles, 1U);
  EXPECT_EQ(result.sampled_handles, 1U);
  const auto warns_of_handle = [](const UpdateResult& of) {
    return std::any_of(of.warnings.begin(), of.warnings.end(), [](const std::string& warning) {
      return warning.find("1 handle") != std::string::npos;
    });
  };
  EXPECT_FALSE(warns_of_handle(result));
  // Where so wide a handle counts as narrow it is told.
  UpdateOptions options;
  options.handles.wide = 100;
  const UpdateResult narrow = update_model(model, Clouds{drilled_tube(0.045)}, options);
  EXPECT_EQ(narrow.sampled_handles, 0U);
  EXPECT_TRUE(warns_of_handle(narrow));
}

// Two boxes that share an edge, each closed by itself, as --manifold leaves contacts: the vertices
// of the edge are there twice before, and once after the update of a place far from it.
TEST(UpdateWithHandles, SplitContactsAreNoHandles) {
  TriangleMesh model = reconstruct_tight(gallery::box_faces(8)).mesh;
  const std::size_t vertices = model.points.size();
  const std::size_t triangles = model.triangles.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    model.points.push_back(model.points[VertexId(v)] + Vec3{2, 0, 1});
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto [a, b, c] = model.triangles[TriangleId(t)];
    model.triangles.push_back({VertexId(vertices + a.index()), VertexId(vertices + b.index()),
                               VertexId(vertices + c.index())});
  }
  EXPECT_EQ(repeated_vertices(ModelIndex(model)), 25U);
  std::vector<std::vector<Point>> clouds(1);
  for (int i = -25; i <= 25; ++i) {
    for (int k = -25; k <= 25; ++k) {
      const double r = 0.018 * std::sqrt(static_cast<double>(i * i + k * k));
      if (r > 0.45) continue;
      clouds[0].push_back({3 + 0.018 * i, 0.75 + 0.018 * k, 2 + 0.1 * hill(r, 0.3)});
    }
  }
  const UpdateResult result = update_model(model, clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.euler, result.euler_before);
  EXPECT_EQ(result.unexplained_handles, 0U);
}

}  // namespace
}  // namespace cocoon
