#include "cocone/umbrella.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "cocone/facets/facet_removal.h"
#include "geom/random/random.h"
#include "tests/cocone/octahedron.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

// The facets at each edge of each facet.
using Neighbors = std::map<std::pair<FacetId, std::uint32_t>, std::set<FacetId>>;

Neighbors neighbors(const LinkedFacets& triangles) {
  Neighbors found;
  for (Halfedge halfedge = 0; halfedge < triangles.links.size(); ++halfedge) {
    auto& at_edge =
        found[{triangles.facets[triangle_of_halfedge(halfedge)], corner_of_halfedge(halfedge)}];
    for_each_at_edge(triangles.links, halfedge, [&](Halfedge other) {
      at_edge.insert(triangles.facets[triangle_of_halfedge(other)]);
    });
  }
  return found;
}

TEST(LinkedFacets, WithoutSomeTrianglesAreTheOthersLinked) {
  const Stages s(shapes::random_torus(400, 0.4, 5));
  Random random(9);
  for (const double share : {0.0, 0.01, 0.6, 1.0}) {
    FacetSet all(s.triangulation.num_cells());  // many at each edge
    for (const CellId c : s.triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) all.insert(s.triangulation, facet_id(c, i));
    }
    const LinkedFacets triangles = link_facets(s.triangulation, all);
    std::vector<std::uint8_t> removed;
    for (const FacetId f : triangles.facets) {
      removed.push_back(random.uniform(0, 1) < share ? 1 : 0);
      if (removed.back() != 0) all.erase(s.triangulation, f);
    }
    const LinkedFacets left = without(s.triangulation, triangles, removed);
    const LinkedFacets anew = link_facets(s.triangulation, all);
    EXPECT_EQ(left.set, anew.set);
    EXPECT_EQ(left.size(), anew.size());
    EXPECT_EQ(neighbors(left), neighbors(anew));
    const auto count_edges = [](const LinkedFacets& of) {
      std::size_t count = 0;
      for (Halfedge halfedge = 0; halfedge < of.links.size(); ++halfedge)
        count += of.is_first(halfedge) ? 1U : 0U;
      return count;
    };
    EXPECT_EQ(count_edges(left), count_edges(anew));
  }
}

TEST(Umbrella, ClosedSurfaceHasGoodVertices) {
  const Octahedron o;
  ASSERT_EQ(o.triangulation.num_finite_cells(), 8U);
  const FacetSet hull = o.facets([&](FacetId f) { return o.on_hull(f); });
  const LinkedFacets fans = link_facets(o.triangulation, hull);
  EXPECT_EQ(fans.size(), 8U);
  const GoodVertices good = good_vertices(fans, no_boundary(o.triangulation));
  EXPECT_EQ(good.count, 6U);
  EXPECT_EQ(good.good[o.vertex({0, 0, 0})], 0);
  const VertexSet umbrella = vertices_with_umbrella(fans, o.triangulation.num_vertices(), 0.5);
  EXPECT_EQ(std::count(umbrella.begin(), umbrella.end(), 1), 6);
}

TEST(Umbrella, AMissingTriangleMakesItsCornersPoor) {
  const Octahedron o;
  const VertexId x = o.vertex({1, 0, 0});
  const VertexId y = o.vertex({0, 1, 0});
  const VertexId z = o.vertex({0, 0, 1});
  const FacetSet torn = o.facets([&](FacetId f) {
    return o.on_hull(f) && !(o.contains(f, x) && o.contains(f, y) && o.contains(f, z));
  });
  const LinkedFacets fans = link_facets(o.triangulation, torn);
  const GoodVertices good = good_vertices(fans, no_boundary(o.triangulation));
  EXPECT_EQ(good.count, 3U);
  for (const VertexId v : {x, y, z}) EXPECT_EQ(good.good[v], 0);
  // around the corners of the hole nothing closes either
  const VertexSet umbrella = vertices_with_umbrella(fans, o.triangulation.num_vertices(), 0.5);
  for (const VertexId v : {x, y, z}) EXPECT_EQ(umbrella[v], 0);
}

TEST(Umbrella, AThirdTriangleAtASpokeMakesAVertexPoorButLeavesItsUmbrella) {
  const Octahedron o;
  const VertexId x = o.vertex({1, 0, 0});
  const VertexId y = o.vertex({0, 1, 0});
  const LinkedFacets fans = link_facets(o.triangulation, o.hull_with_flap());
  ASSERT_EQ(fans.size(), 9U);
  const GoodVertices good = good_vertices(fans, no_boundary(o.triangulation));
  EXPECT_EQ(good.good[x], 0);
  EXPECT_EQ(good.good[y], 0);
  EXPECT_EQ(good.count, 4U);
  EXPECT_EQ(vertices_with_umbrella(fans, o.triangulation.num_vertices(), 0.5)[x], 1);
}

TEST(Umbrella, BoundarySamplesAtCreasesAreDemoted) {
  // The dihedral of the octahedron is 109.5 degrees. Taken as a crease, its boundary samples are
  // poor; taken as a fold, every vertex is.
  const Octahedron o;
  const FacetSet hull = o.facets([&](FacetId f) { return o.on_hull(f); });
  const LinkedFacets fans = link_facets(o.triangulation, hull);
  VertexSet boundary = no_boundary(o.triangulation);
  boundary[o.vertex({1, 0, 0})] = 1;
  EXPECT_EQ(good_vertices(fans, boundary).count, 6U);
  const GoodVertices creased = good_vertices(fans, boundary, {.crease_cosine = -0.5});
  EXPECT_EQ(creased.count, 5U);
  EXPECT_EQ(creased.folded.size(), 1U);
  EXPECT_EQ(good_vertices(fans, boundary, {.fold_cosine = -0.5}).folded.size(), 6U);
}

// The number of cycles that the triangles at v make, two at each spoke; 0 if some spoke has another
// number.
std::size_t cycles_at(const LinkedFacets& triangles, VertexId v) {
  std::vector<std::uint32_t> fan;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle& corners = triangles.corners[t];
    if (std::find(corners.begin(), corners.end(), v) != corners.end()) fan.push_back(t);
  }
  std::set<std::uint32_t> met;
  std::size_t cycles = 0;
  for (const std::uint32_t first : fan) {
    cycles += met.contains(first) ? 0U : 1U;
    for (std::vector<std::uint32_t> open = {first}; !open.empty();) {
      const std::uint32_t t = open.back();
      open.pop_back();
      if (!met.insert(t).second) continue;
      for (Halfedge halfedge = 3 * t; halfedge < 3 * t + 3; ++halfedge) {
        if (triangles.corners[t][corner_of_halfedge(halfedge)] == v) continue;
        if (!triangles.has_two_triangles(halfedge)) return 0;
        open.push_back(triangle_of_halfedge(triangles.links[halfedge]));
      }
    }
  }
  return cycles;
}

// Bodies that touch themselves at vertices and edges.
TEST(Umbrella, OneCycleOfTrianglesIsGood) {
  const Stages s(shapes::random_cube(400, 7));
  Random random(3);
  std::size_t pinched = 0;
  for (const double share : {0.01, 0.05, 0.2}) {
    IdVector<CellId, std::uint8_t> body(s.triangulation.num_cells(), 0);
    for (const CellId c : s.triangulation.finite_cells()) {
      body[c] = random.uniform(0, 1) < share ? 1 : 0;
    }
    FacetSet boundary(s.triangulation.num_cells());
    for (const CellId c : s.triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        if (body[c] == body[s.triangulation.neighbor(c, i)]) continue;
        boundary.insert(s.triangulation, facet_id(c, i));
      }
    }
    const LinkedFacets triangles = link_facets(s.triangulation, boundary);
    const GoodVertices good =
        good_vertices(triangles, no_boundary(s.triangulation), {.fold_cosine = 2});
    for (const VertexId v : s.triangulation.vertices()) {
      const std::size_t cycles = cycles_at(triangles, v);
      EXPECT_EQ(good.good[v] != 0, cycles == 1);
      pinched += cycles > 1 ? 1U : 0U;
    }
  }
  EXPECT_GT(pinched, 20U);
}

}  // namespace
}  // namespace cocoon
