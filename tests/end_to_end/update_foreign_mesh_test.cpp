// Updates of a mesh whose triangles are no facets of the triangulation of its vertices.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/triangle_normal.h"
#include "io/point_file.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

using Edge = std::pair<VertexId, VertexId>;

Vec3 normal_of(const TriangleMesh& mesh, const Triangle& t) {
  return triangle_normal(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]).direction;
}

// Random edges have the other diagonal, as long as triangles do not turn over.
TriangleMesh with_other_diagonals(TriangleMesh mesh, std::uint64_t seed) {
  std::map<Edge, TriangleId> left_of;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& v = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) left_of[{v[i], v[(i + 1) % 3]}] = t;
  }
  Random random(seed);
  std::set<TriangleId> used;
  std::set<Edge> made;
  for (const auto& [edge, t] : left_of) {
    const VertexId a = edge.first;
    const VertexId b = edge.second;
    const TriangleId other = left_of.at({b, a});
    if (b < a || random.uniform() > 0.6 || used.contains(t) || used.contains(other)) continue;
    const auto apex = [&](TriangleId of) {
      const Triangle& v = mesh.triangles[of];
      return *std::find_if(v.begin(), v.end(), [&](VertexId w) { return w != a && w != b; });
    };
    const VertexId c = apex(t);
    const VertexId d = apex(other);
    const Triangle first = {c, d, b};
    const Triangle second = {d, c, a};
    const Vec3 n = normal_of(mesh, mesh.triangles[t]);
    const bool holds = dot(n, normal_of(mesh, mesh.triangles[other])) > 0 &&
                       dot(n, normal_of(mesh, first)) > 0 && dot(n, normal_of(mesh, second)) > 0;
    const Edge diagonal = std::minmax(c, d);
    if (!holds || left_of.contains({c, d}) || !made.insert(diagonal).second) continue;
    mesh.triangles[t] = first;
    mesh.triangles[other] = second;
    used.insert(t);
    used.insert(other);
  }
  return mesh;
}

TriangleMesh anchor() {
  return reconstruct_tight(
             read_points(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off").points)
      .mesh;
}

// Of the model as it is, around one of its vertices.
std::vector<std::vector<Point>> rescan_of(const TriangleMesh& model, std::uint64_t seed) {
  double size = 0;
  for (const Point& p : model.points) {
    size = std::max(size, distance(p, model.points[VertexId(0U)]));
  }
  const double radius = 0.15 * size;
  std::vector<std::vector<Point>> clouds(1);
  Random random(seed);
  for (const Point& p : model.points) {
    if (distance(p, model.points[VertexId(1000)]) > radius) continue;
    clouds[0].push_back(p + 0.01 * radius * random.on_unit_sphere());
  }
  return clouds;
}

// Nothing has changed, and far from the scan nothing does. What the mesh tells does not fit what
// good vertices do.
TEST(UpdateForeignMesh, ARescanLeavesItAManifold) {
  const TriangleMesh ours = anchor();
  for (const std::uint64_t seed : {2U, 3U, 4U, 5U}) {
    const TriangleMesh model = with_other_diagonals(ours, seed);
    const MeshReport before = mesh_check(model);
    ASSERT_TRUE(before.is_closed_manifold());
    const std::vector<std::vector<Point>> clouds = rescan_of(model, seed);
    UpdateOptions obstinate;
    obstinate.reconstruct.yield_rounds = 0;
    EXPECT_FALSE(mesh_check(update_model(model, clouds, obstinate).mesh).is_closed_manifold());
    const UpdateResult result = update_model(model, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    const MeshReport after = mesh_check(result.mesh);
    EXPECT_TRUE(after.is_closed_manifold()) << "seed " << seed;
    EXPECT_EQ(after.euler, before.euler);
    EXPECT_GT(result.reconstruction.counters.yielded_cells, 0U);
  }
}

// Unit cubes.
using Cubes = std::function<bool(const std::array<int, 3>&)>;

// The squares between the cubes of a body and others, counterclockwise seen from outside. All of it
// is within 0..size.
std::vector<std::array<Point, 4>> squares_of(const Cubes& body, int size) {
  std::vector<std::array<Point, 4>> squares;
  for (int i = 0; i < size * size * size; ++i) {
    const std::array<int, 3> cube = {i % size, i / size % size, i / size / size};
    if (!body(cube)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        std::array<int, 3> next = cube;
        next[axis] += step;
        if (body(next)) continue;
        const auto corner = [&](int u, int v) {
          std::array<int, 3> p = cube;
          p[axis] += step > 0 ? 1 : 0;
          p[(axis + 1) % 3] += step > 0 ? u : v;
          p[(axis + 2) % 3] += step > 0 ? v : u;
          return Point{1.0 * p[0], 1.0 * p[1], 1.0 * p[2]};
        };
        squares.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
      }
    }
  }
  return squares;
}

// Two triangles for each square, with any of its diagonals.
TriangleMesh any_diagonals(const std::vector<std::array<Point, 4>>& squares, std::uint64_t seed) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, VertexId> ids;
  Random random(seed);
  for (const std::array<Point, 4>& square : squares) {
    std::array<VertexId, 4> v;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point& p = square[i];
      const auto [at, is_new] = ids.try_emplace({p.x, p.y, p.z}, VertexId(mesh.points.size()));
      if (is_new) mesh.points.push_back(p);
      v[i] = at->second;
    }
    const std::size_t first = random.uniform() < 0.5 ? 0 : 1;
    mesh.triangles.push_back({v[first], v[first + 1], v[first + 2]});
    mesh.triangles.push_back({v[first], v[first + 2], v[(first + 3) % 4]});
  }
  return mesh;
}

bool is_between(int x, int low, int high) { return low <= x && x < high; }

// A bar with a pocket two cubes wide, too narrow for its spacing.
bool is_in_bar(const std::array<int, 3>& p) {
  const bool in_pocket = is_between(p[0], 8, 10) && is_between(p[1], 8, 10) && p[2] >= 10;
  return is_between(p[0], 4, 28) && is_between(p[1], 4, 16) && is_between(p[2], 4, 16) &&
         !in_pocket;
}

// And a boss put on far from it.
bool is_in_changed_bar(const std::array<int, 3>& p) {
  return is_in_bar(p) ||
         (is_between(p[0], 20, 25) && is_between(p[1], 7, 12) && is_between(p[2], 16, 19));
}

TriangleMesh bar(std::uint64_t seed) { return any_diagonals(squares_of(is_in_bar, 32), seed); }

std::vector<std::vector<Point>> scan_of_boss() {
  std::vector<std::vector<Point>> clouds(1);
  for (const auto& [a, b, c, d] : squares_of(is_in_changed_bar, 32)) {
    const Point center = 0.5 * (a + c);
    if (center.x < 17 || center.z < 13) continue;
    for (const double u : {0.25, 0.75}) {
      for (const double v : {0.25, 0.75}) clouds[0].push_back(a + u * (b - a) + v * (d - a));
    }
  }
  return clouds;
}

TEST(UpdateForeignMesh, AGridKeepsItsNarrowPocket) {
  const std::vector<std::vector<Point>> clouds = scan_of_boss();
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const TriangleMesh model = bar(seed);
    ASSERT_TRUE(mesh_check(model).is_closed_manifold());
    const UpdateResult result = update_model(model, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold()) << "seed " << seed;
    EXPECT_EQ(mesh_check(result.mesh).euler, 2) << "seed " << seed;
    const auto in_pocket = [](const Point& p) { return p.x < 17; };
    EXPECT_EQ(std::count_if(result.mesh.points.begin(), result.mesh.points.end(), in_pocket),
              std::count_if(model.points.begin(), model.points.end(), in_pocket));
  }
}

// What was taken back leads to the same again, though by local steps.
TEST(UpdateForeignMesh, ASessionGivesTheSame) {
  const TriangleMesh other = with_other_diagonals(anchor(), 2);
  const std::pair<TriangleMesh, std::vector<std::vector<Point>>> cases[] = {
      {bar(1), scan_of_boss()}, {other, rescan_of(other, 2)}};
  for (const auto& [model, clouds] : cases) {
    const UpdateResult expected = update_model(model, clouds);
    ASSERT_EQ(expected.status, UpdateStatus::ok) << expected.message;
    UpdateSession session(model);
    for (int i = 0; i < 3; ++i) {
      const UpdateResult result = session.apply(clouds).result;
      EXPECT_EQ(result.status, UpdateStatus::ok);
      EXPECT_EQ(result.warnings, expected.warnings);
      EXPECT_TRUE(session.model() == expected.mesh) << "step " << i;
      session.undo();
      EXPECT_TRUE(session.model() == model);
    }
  }
}

}  // namespace
}  // namespace cocoon
