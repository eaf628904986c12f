#include "geom/mesh/changed_neighbors.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "geom/random/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// A closed mesh and what becomes of it.
struct Change {
  explicit Change(TriangleMesh mesh)
      : before(std::move(mesh)), neighbors(triangle_neighbors(before)) {
    for (const VertexId v : before.points.ids()) vertex_map.push_back(v);
  }

  // Cuts random triangles in three, and turns the list round.
  void split_triangles(std::size_t count, Random& random) {
    std::vector<std::uint8_t> cut(before.triangles.size(), 0);
    for (std::size_t i = 0; i < count; ++i) cut[random.below(cut.size())] = 1;
    after.points = before.points;
    std::vector<Triangle> triangles;
    std::vector<TriangleId> sources;
    for (const TriangleId t : before.triangles.ids()) {
      const auto& [a, b, c] = before.triangles[t];
      if (cut[t.index()] == 0) {
        triangles.push_back({b, c, a});
        sources.push_back(t);
        continue;
      }
      const VertexId v = after.points.push_back((after.points[a] + after.points[b]) / 2);
      for (const Triangle& part : {Triangle{a, b, v}, Triangle{b, c, v}, Triangle{v, c, a}}) {
        triangles.push_back(part);
        sources.emplace_back();
      }
    }
    std::reverse(triangles.begin(), triangles.end());
    std::reverse(sources.begin(), sources.end());
    after.triangles = IdVector<TriangleId, Triangle>(std::move(triangles));
    triangle_map = IdVector<TriangleId, TriangleId>(before.triangles.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (!sources[i].is_none()) triangle_map[sources[i]] = TriangleId(i);
    }
  }

  std::optional<ChangedNeighbors> changed() const {
    return changed_neighbors(after, {before, neighbors, vertex_map, triangle_map});
  }

  TriangleMesh before;
  TriangleNeighbors neighbors;
  TriangleMesh after;
  IdVector<VertexId, VertexId> vertex_map;
  IdVector<TriangleId, TriangleId> triangle_map;
};

TEST(ChangedNeighbors, EqualThoseOfTheWhole) {
  Random random(1);
  for (const std::size_t cuts : {0U, 1U, 7U, 200U}) {
    Change change(gallery::sphere(3));
    change.split_triangles(cuts, random);
    const auto changed = change.changed();
    ASSERT_TRUE(changed.has_value());
    const TriangleNeighbors whole = triangle_neighbors(change.after);
    const TrianglesAtVertices at_vertices = triangles_at_vertices(change.after);
    EXPECT_EQ(changed->neighbors.raw(), whole.raw());
    EXPECT_EQ(changed->at_vertices.begins, at_vertices.begins);
    EXPECT_EQ(changed->at_vertices.triangles, at_vertices.triangles);
    EXPECT_EQ(changed->seam.empty(), cuts == 0);
    EXPECT_TRUE(std::is_sorted(changed->seam.begin(), changed->seam.end()));
    if (cuts == 1) {
      EXPECT_EQ(changed->seam.size(), 6U);  // three new ones, and the three beside them
    }
  }
}

TEST(ChangedNeighbors, OpenEdgesAreLeftToTheWhole) {
  Random random(2);
  Change open(gallery::sphere(2));
  open.split_triangles(3, random);
  std::vector<Triangle> fewer = open.after.triangles.raw();
  fewer.pop_back();
  open.after.triangles = IdVector<TriangleId, Triangle>(fewer);
  for (TriangleId& t : open.triangle_map) {
    if (!t.is_none() && t.index() >= fewer.size()) t = {};
  }
  EXPECT_FALSE(open.changed().has_value());

  // Open before, closed after.
  Change closing(open.after);
  closing.after = open.before;
  closing.triangle_map = IdVector<TriangleId, TriangleId>(closing.before.triangles.size());
  closing.vertex_map = IdVector<VertexId, VertexId>(closing.before.points.size());
  EXPECT_FALSE(closing.changed().has_value());
}

TEST(ChangedNeighbors, AThirdTriangleAtAnEdgeIsLeftToTheWhole) {
  Random random(3);
  Change fin(gallery::sphere(2));
  fin.split_triangles(0, random);
  const Triangle first = fin.after.triangles[TriangleId(0)];
  const VertexId tip = fin.after.points.push_back({0, 0, 5});
  // Two equal fins: each of their free sides meets one other, but not those at the old edge.
  fin.after.triangles.push_back({first[0], first[1], tip});
  fin.after.triangles.push_back({first[1], first[0], tip});
  EXPECT_FALSE(fin.changed().has_value());
}

}  // namespace
}  // namespace cocoon
