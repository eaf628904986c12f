#include "geom/mesh/halfedges.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using Edge = std::pair<VertexId, VertexId>;

std::map<Edge, std::vector<Halfedge>> halfedges_by_edge(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<Halfedge>> halfedges;
  for (Halfedge halfedge = 0; halfedge < 3 * triangles.size(); ++halfedge) {
    const Triangle& triangle = triangles[triangle_of_halfedge(halfedge)];
    const VertexId a = triangle[next_corner(corner_of_halfedge(halfedge))];
    const VertexId b = triangle[previous_corner(corner_of_halfedge(halfedge))];
    halfedges[{std::min(a, b), std::max(a, b)}].push_back(halfedge);
  }
  return halfedges;
}

void expect_rings(const std::vector<Triangle>& triangles, std::size_t num_vertices) {
  for (const int threads : {1, 3}) {
    const HalfedgeLinks links = halfedge_links(triangles, num_vertices, {.threads = threads});
    for (const auto& [edge, halfedges] : halfedges_by_edge(triangles)) {
      for (std::size_t k = 0; k < halfedges.size(); ++k) {
        const bool alone = edge.first == edge.second;
        EXPECT_EQ(links[halfedges[k]],
                  alone ? halfedges[k] : halfedges[(k + 1) % halfedges.size()]);
      }
    }
  }
}

// The triangles that repeat no vertex, by their smallest ones: linked by their groups as by all.
void expect_rings_of_groups(std::vector<Triangle> triangles, std::size_t num_vertices) {
  const auto smallest = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}); };
  std::erase_if(triangles, repeats_a_vertex);
  std::stable_sort(triangles.begin(), triangles.end(),
                   [&](const Triangle& a, const Triangle& b) { return smallest(a) < smallest(b); });
  std::vector<std::uint32_t> begins(num_vertices + 1, 0);
  for (const Triangle& t : triangles) ++begins[smallest(t).index() + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  const HalfedgeLinks expected = halfedge_links(triangles, num_vertices);
  for (const int threads : {1, 2, 3}) {
    EXPECT_EQ(halfedge_links(triangles, begins, {.threads = threads}), expected);
  }
}

TEST(HalfedgeLinks, AClosedMeshHasPairs) {
  const TriangleMesh mesh = gallery::torus(9, 7);
  expect_rings(mesh.triangles.raw(), mesh.points.size());
  expect_rings_of_groups(mesh.triangles.raw(), mesh.points.size());
  const HalfedgeLinks links = halfedge_links(mesh.triangles.span(), mesh.points.size());
  for (Halfedge halfedge = 0; halfedge < links.size(); ++halfedge) {
    EXPECT_NE(links[halfedge], halfedge);
    EXPECT_EQ(links[links[halfedge]], halfedge);
  }
}

TEST(HalfedgeLinks, RubbishMakesRingsOfAnyLength) {
  Random random(11);
  std::vector<Triangle> triangles;
  for (int k = 0; k < 3000; ++k) {
    const auto any = [&] { return VertexId(static_cast<std::uint32_t>(random.uniform(0, 40))); };
    triangles.push_back({any(), any(), any()});  // some repeat a vertex
  }
  expect_rings(triangles, 40);
  expect_rings_of_groups(triangles, 40);
}

TEST(HalfedgeLinks, AVertexOfGreatValence) {
  std::vector<Triangle> triangles;
  for (std::uint32_t k = 1; k <= 5000; ++k) {
    triangles.push_back({VertexId(0), VertexId(k), VertexId(k % 5000 + 1)});
  }
  expect_rings(triangles, 5001);
  expect_rings_of_groups(triangles, 5001);
}

TriangleMesh rubbish(Random& random) {
  TriangleMesh mesh;
  mesh.points.resize(30);
  for (int k = 0; k < 400; ++k) {
    const auto any = [&] { return VertexId(static_cast<std::uint32_t>(random.below(30))); };
    mesh.triangles.push_back({any(), any(), any()});  // some repeat a vertex
  }
  return mesh;
}

// The halfedges of a triangle that repeats a vertex are on no edge; those of others are linked as
// if it were not there.
TEST(HalfedgeRings, ATriangleThatRepeatsAVertexHasNoEdges) {
  Random random(3);
  const TriangleMesh mesh = rubbish(random);
  const HalfedgeRings rings = link_halfedges(mesh);
  std::vector<std::uint8_t> repeats;
  TriangleMesh proper{mesh.points, {}};
  for (const Triangle& t : mesh.triangles) {
    repeats.push_back(t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ? 1 : 0);
    if (repeats.back() == 0) proper.triangles.push_back(t);
  }
  for (Halfedge halfedge = 0; halfedge < rings.links.size(); ++halfedge) {
    EXPECT_EQ(rings.has_edge(halfedge), repeats[triangle_of_halfedge(halfedge)] == 0);
    EXPECT_FALSE(!rings.has_edge(halfedge) && rings.has_two_triangles(halfedge));
  }
  EXPECT_EQ(link_rest(rings, repeats).links, link_halfedges(proper).links);
}

TEST(HalfedgeRings, WhatIsLeftIsLinkedAsAMeshOfItsOwn) {
  Random random(4);
  for (const TriangleMesh& mesh : {gallery::torus(9, 7), rubbish(random)}) {
    TriangleMesh rest{mesh.points, {}};
    std::vector<std::uint8_t> removed;
    for (const Triangle& t : mesh.triangles) {
      removed.push_back(random.below(3) == 0 ? 1 : 0);
      if (removed.back() == 0) rest.triangles.push_back(t);
    }
    EXPECT_EQ(link_rest(link_halfedges(mesh), removed).links, link_halfedges(rest).links);
  }
}

TEST(HalfedgeRings, EachEdgeHasOneLastHalfedge) {
  const TriangleMesh mesh = gallery::torus(9, 7);
  const HalfedgeRings rings = link_halfedges(mesh);
  std::size_t edges = 0;
  for (Halfedge halfedge = 0; halfedge < rings.links.size(); ++halfedge) {
    EXPECT_TRUE(rings.has_two_triangles(halfedge));
    EXPECT_FALSE(rings.is_open(halfedge));
    edges += rings.is_last(halfedge) ? 1U : 0U;
  }
  EXPECT_EQ(edges, 3 * mesh.triangles.size() / 2);
}

// Whether the triangles are in the order of their smallest vertices, or one of them out of it.
TEST(HalfedgeRings, TheOrderOfTrianglesDoesNotMatter) {
  Random random(5);
  for (TriangleMesh mesh : {gallery::torus(9, 7), rubbish(random)}) {
    std::vector<Triangle>& triangles = mesh.triangles.raw();
    std::erase_if(triangles, repeats_a_vertex);
    std::stable_sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
      return a[smallest_corner(a)] < b[smallest_corner(b)];
    });
    for (const std::size_t unused : {0U, 1U, 7U}) {
      mesh.points.resize(mesh.points.size() + unused);
      EXPECT_EQ(link_halfedges(mesh).links,
                halfedge_links(mesh.triangles.span(), mesh.points.size()));
    }
    std::swap(triangles.front(), triangles.back());
    EXPECT_EQ(link_halfedges(mesh).links,
              halfedge_links(mesh.triangles.span(), mesh.points.size()));
  }
}

TEST(HalfedgeRings, RefusesAVertexThatIsNotThere) {
  TriangleMesh mesh;
  mesh.points.resize(3);
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(3)});
  EXPECT_THROW(link_halfedges(mesh), InputError);
}

TEST(IsBalanced, AsTheCheckSays) {
  TriangleMesh twice = gallery::open_patch(3, 3);
  for (const Triangle& t : gallery::flipped(twice).triangles) twice.triangles.push_back(t);
  TriangleMesh with_point = gallery::cube();
  with_point.triangles.push_back({VertexId(1), VertexId(1), VertexId(2)});
  TriangleMesh turned = gallery::cube();
  std::swap(turned.triangles[TriangleId(0)][0], turned.triangles[TriangleId(0)][1]);
  TriangleMesh improper = gallery::make_mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}});
  std::size_t balanced = 0;
  for (const TriangleMesh& mesh :
       {TriangleMesh(), gallery::cube(), gallery::flipped(gallery::cube()), with_point, twice,
        turned, improper, gallery::open_patch(4, 5), gallery::moebius_strip(7),
        gallery::projective_plane(), gallery::two_tetrahedra_sharing_an_edge(),
        gallery::torus(9, 7), gallery::random_soup(50, 3)}) {
    const bool expected = mesh_check(mesh).balanced;
    EXPECT_EQ(is_balanced(mesh, link_halfedges(mesh), {2}), expected);
    balanced += expected ? 1 : 0;
  }
  EXPECT_EQ(balanced, 6U);
}

}  // namespace
}  // namespace cocoon
