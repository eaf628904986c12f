#include "geom/linked_sides.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "geom/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TriangleMesh rubbish(Random& random) {
  TriangleMesh mesh;
  mesh.points.resize(30);
  for (int k = 0; k < 400; ++k) {
    const auto any = [&] { return VertexId(static_cast<std::uint32_t>(random.below(30))); };
    mesh.triangles.push_back({any(), any(), any()});  // some repeat a vertex
  }
  return mesh;
}

// The sides of a triangle that repeats a vertex are on no edge; those of others are linked as if it
// were not there.
TEST(LinkedSides, ATriangleThatRepeatsAVertexHasNoEdges) {
  Random random(3);
  const TriangleMesh mesh = rubbish(random);
  const LinkedSides sides = link_sides(mesh);
  std::vector<std::uint8_t> repeats;
  TriangleMesh proper{mesh.points, {}};
  for (const Triangle& t : mesh.triangles) {
    repeats.push_back(t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ? 1 : 0);
    if (repeats.back() == 0) proper.triangles.push_back(t);
  }
  for (SideId side = 0; side < sides.links.size(); ++side) {
    EXPECT_EQ(sides.has_edge(side), repeats[triangle_of_side(side)] == 0);
    EXPECT_FALSE(!sides.has_edge(side) && sides.is_two_sided(side));
  }
  EXPECT_EQ(link_rest(sides, repeats).links, link_sides(proper).links);
}

TEST(LinkedSides, WhatIsLeftIsLinkedAsAMeshOfItsOwn) {
  Random random(4);
  for (const TriangleMesh& mesh : {gallery::torus(9, 7), rubbish(random)}) {
    TriangleMesh rest{mesh.points, {}};
    std::vector<std::uint8_t> removed;
    for (const Triangle& t : mesh.triangles) {
      removed.push_back(random.below(3) == 0 ? 1 : 0);
      if (removed.back() == 0) rest.triangles.push_back(t);
    }
    EXPECT_EQ(link_rest(link_sides(mesh), removed).links, link_sides(rest).links);
  }
}

TEST(LinkedSides, EachEdgeHasOneFirstSide) {
  const TriangleMesh mesh = gallery::torus(9, 7);
  const LinkedSides sides = link_sides(mesh);
  std::size_t edges = 0;
  for (SideId side = 0; side < sides.links.size(); ++side) {
    EXPECT_TRUE(sides.is_two_sided(side));
    EXPECT_FALSE(sides.is_open(side));
    edges += sides.is_first(side) ? 1U : 0U;
  }
  EXPECT_EQ(edges, 3 * mesh.triangles.size() / 2);
}

TEST(LinkedSides, RefusesAVertexThatIsNotThere) {
  TriangleMesh mesh;
  mesh.points.resize(3);
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(3)});
  EXPECT_THROW(link_sides(mesh), InputError);
}

}  // namespace
}  // namespace cocoon
