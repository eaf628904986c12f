#include "geom/mesh/narrow_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "geom/arrays/disjoint_sets.h"
#include "geom/errors.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/mesh_check.h"
#include "geom/triangle_mesh.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using Edge = std::pair<VertexId, VertexId>;

std::set<Edge> edges_of(const NarrowHandle& handle) {
  std::set<Edge> edges;
  for (std::size_t k = 0; k < handle.path.size(); ++k) {
    edges.insert(std::minmax(handle.path[k], handle.path[(k + 1) % handle.path.size()]));
  }
  return edges;
}

// Into how many pieces triangles fall that are joined across all other edges.
std::size_t pieces_without(const LinkedMesh& mesh, const std::set<Edge>& cut) {
  std::size_t pieces = mesh.triangles.size();
  std::size_t found = 0;
  DisjointSets joined(pieces);
  for (Halfedge halfedge = 0; halfedge < mesh.links.size(); ++halfedge) {
    if (!mesh.is_last(halfedge)) continue;
    if (cut.contains(std::minmax(mesh.from(halfedge), mesh.to(halfedge)))) {
      ++found;
      continue;
    }
    pieces -=
        joined.join(triangle_of_halfedge(halfedge), triangle_of_halfedge(mesh.links[halfedge]))
            ? 1U
            : 0U;
  }
  EXPECT_EQ(found, cut.size());  // the path runs along edges
  return pieces;
}

TEST(NarrowHandles, NoneOnABall) {
  EXPECT_TRUE(narrow_handles(link_mesh(gallery::cube()), 5).empty());
  EXPECT_TRUE(narrow_handles(link_mesh({}), 5).empty());
}

TEST(NarrowHandles, GoAroundTheTubeOfARing) {
  const LinkedMesh mesh = link_mesh(gallery::torus(60, 24, 2, 0.5));
  const std::vector<NarrowHandle> handles = narrow_handles(mesh, 1);
  ASSERT_EQ(handles.size(), 1U);
  const double around = 2 * std::numbers::pi * 0.5;
  EXPECT_GE(handles[0].length, 0.98 * around);  // 24 chords
  EXPECT_LE(handles[0].length, 1.3 * around);
  double length = 0;
  for (const auto& [a, b] : edges_of(handles[0])) length += norm(mesh.points[b] - mesh.points[a]);
  EXPECT_NEAR(handles[0].length, length, 1e-12 * length);
  EXPECT_EQ(pieces_without(mesh, edges_of(handles[0])), 1U);
}

// A thin ring, a fat one and a ball: the thin one comes first, and the ball has none.
TEST(NarrowHandles, TheNarrowestFirst) {
  const TriangleMesh all =
      gallery::join(gallery::join(gallery::torus(40, 20, 2, 0.9),
                                  gallery::translated(gallery::cube(), {5, 5, 5})),
                    gallery::translated(gallery::torus(40, 20, 2, 0.2), {0, 0, 9}));
  ASSERT_EQ(mesh_check(all).genus, 2U);
  const LinkedMesh mesh = link_mesh(all);
  const std::vector<NarrowHandle> handles = narrow_handles(mesh, 2);
  ASSERT_EQ(handles.size(), 2U);
  EXPECT_LT(handles[0].length, handles[1].length);
  for (const VertexId v : handles[0].path) EXPECT_GT(mesh.points[v].z, 8);
  for (const NarrowHandle& handle : handles) {
    EXPECT_EQ(pieces_without(mesh, edges_of(handle)), 3U);  // as many as without a cut
  }
  EXPECT_EQ(narrow_handles(mesh, 1).size(), 1U);
}

// Of the two ways around a handle one is told.
TEST(NarrowHandles, AreFoundAtAnySize) {
  const TriangleMesh ring = gallery::torus(24, 12);
  const std::vector<NarrowHandle> expected = narrow_handles(link_mesh(ring), 1);
  ASSERT_EQ(expected.size(), 1U);
  for (const double scale : {0x1p+1000, 0x1p-1000, 0x1p+520}) {
    TriangleMesh scaled_ring = ring;
    for (Point& p : scaled_ring.points) p = scale * p;
    const std::vector<NarrowHandle> found = narrow_handles(link_mesh(scaled_ring), 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].path, expected[0].path);
    EXPECT_NEAR(found[0].length / scale, expected[0].length, 1e-12);
  }
  TriangleMesh broken = ring;
  broken.points[VertexId(5U)].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(narrow_handles(link_mesh(broken), 1), InputError);
}

TEST(NarrowHandles, AreNoMoreThanTheGenus) {
  const LinkedMesh ring = link_mesh(gallery::torus(12, 8));
  EXPECT_EQ(narrow_handles(ring, 10).size(), 1U);
  EXPECT_EQ(narrow_handles(ring, 0).size(), 0U);
}

// Edges without length, and some too short to be added to a distance.
TEST(NarrowHandles, EdgesMayHaveNoLength) {
  TriangleMesh torus = gallery::torus(16, 8);
  for (std::size_t i = 40; i < 80; ++i) {
    torus.points[VertexId(i)] = torus.points[VertexId(std::size_t{40})];
    torus.points[VertexId(i)].x += i % 3 == 0 ? 4e-16 : 0;
  }
  const LinkedMesh mesh = link_mesh(torus);
  const std::vector<NarrowHandle> handles = narrow_handles(mesh, 1);
  ASSERT_EQ(handles.size(), 1U);
  EXPECT_EQ(pieces_without(mesh, edges_of(handles[0])), 1U);
}

// A grate of 5 x 5 cells of size 3 without those in odd rows and columns: four holes, and lengths
// are equal all over.
TriangleMesh grate() {
  const auto cell = [](int x, int y) {
    return x >= 0 && x < 5 && y >= 0 && y < 5 && (x % 2 == 0 || y % 2 == 0);
  };
  std::map<Point, VertexId> ids;
  TriangleMesh mesh;
  const auto add_square = [&](const Point& corner, const Vec3& u, const Vec3& v) {
    std::array<VertexId, 4> at;
    const std::array<Point, 4> places = {corner, corner + u, corner + u + v, corner + v};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [entry, is_new] = ids.try_emplace(places[k]);
      if (is_new) entry->second = mesh.points.push_back(places[k]);
      at[k] = entry->second;
    }
    mesh.triangles.push_back({at[0], at[1], at[2]});
    mesh.triangles.push_back({at[0], at[2], at[3]});
  };
  const Vec3 ex{3, 0, 0}, ey{0, 3, 0}, ez{0, 0, 3};
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      if (!cell(x, y)) continue;
      const Point low{3.0 * x, 3.0 * y, 0};
      add_square(low, ey, ex);
      add_square(low + ez, ex, ey);
      if (!cell(x - 1, y)) add_square(low, ez, ey);
      if (!cell(x + 1, y)) add_square(low + ex, ey, ez);
      if (!cell(x, y - 1)) add_square(low, ex, ez);
      if (!cell(x, y + 1)) add_square(low + ey, ez, ex);
    }
  }
  return mesh;
}

// Lengths are rarely equal on a torus, and nearly all of them on a grate.
TEST(NarrowHandles, AreAFunctionOfTheSurface) {
  const auto places = [](const TriangleMesh& given) {
    const LinkedMesh mesh = link_mesh(given);
    std::vector<std::vector<Point>> paths;
    for (const NarrowHandle& handle : narrow_handles(mesh, 5)) {
      std::vector<Point>& path = paths.emplace_back();
      for (const VertexId v : handle.path) path.push_back(mesh.points[v]);
    }
    return paths;
  };
  ASSERT_EQ(mesh_check(grate()).genus, 4U);
  for (const TriangleMesh& mesh : {gallery::torus(16, 8), grate()}) {
    const auto expected = places(mesh);
    ASSERT_GE(expected.size(), 1U);
    for (unsigned seed = 0; seed < 20; ++seed) {
      EXPECT_EQ(places(gallery::shuffled(mesh, seed)), expected);
    }
  }
}

}  // namespace
}  // namespace cocoon
