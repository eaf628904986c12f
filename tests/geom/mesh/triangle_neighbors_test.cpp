#include "geom/mesh/triangle_neighbors.h"

#include <array>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh/halfedges.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using gallery::make_mesh;

// Compares all neighbors, and the halfedges on each edge, with what is counted from scratch.
void expect_right(const TriangleMesh& mesh) {
  std::map<std::set<VertexId>, std::vector<Halfedge>> edges;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& triangle = mesh.triangles[t];
    if (std::set<VertexId>(triangle.begin(), triangle.end()).size() < 3) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      edges[{triangle[(i + 1) % 3], triangle[(i + 2) % 3]}].push_back(halfedge_of(t, i));
    }
  }
  TriangleNeighbors expected(mesh.triangles.size());
  const HalfedgeRings rings = link_halfedges(mesh);
  for (const auto& [ends, halfedges] : edges) {
    std::vector<Halfedge> ring;
    for_each_at_edge(rings.links, halfedges[0], [&](Halfedge h) { ring.push_back(h); });
    EXPECT_EQ(ring, halfedges);
    for (const Halfedge h : halfedges) EXPECT_EQ(first_at_edge(rings.links, h), halfedges[0]);
    if (halfedges.size() != 2) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      expected[TriangleId(triangle_of_halfedge(halfedges[k]))][corner_of_halfedge(halfedges[k])] =
          TriangleId(triangle_of_halfedge(halfedges[1 - k]));
    }
  }
  EXPECT_EQ(triangle_neighbors(mesh), expected);
}

TEST(TriangleNeighbors, TetrahedronHasEveryTriangleBesideEveryOther) {
  const TriangleMesh mesh = gallery::tetrahedron();
  const TriangleNeighbors neighbors = triangle_neighbors(mesh);
  for (const TriangleId t : mesh.triangles.ids()) {
    std::set<TriangleId> around(neighbors[t].begin(), neighbors[t].end());
    EXPECT_EQ(around.size(), 3U);
    EXPECT_EQ(around.count(t), 0U);
    EXPECT_EQ(around.count(TriangleId()), 0U);
  }
}

TEST(TriangleNeighbors, HalfedgesAreOppositeTheirCorner) {
  const TriangleMesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {3, 2, 1}});
  EXPECT_EQ(ends_of_halfedge(mesh, halfedge_of(TriangleId(0), 0)),
            (std::array{VertexId(1), VertexId(2)}));
  EXPECT_EQ(ends_of_halfedge(mesh, halfedge_of(TriangleId(0), 1)),
            (std::array{VertexId(2), VertexId(0)}));
  const TriangleNeighbors neighbors = triangle_neighbors(mesh);
  EXPECT_EQ(neighbors[TriangleId(0)], (std::array{TriangleId(1), TriangleId(), TriangleId()}));
  EXPECT_EQ(neighbors[TriangleId(1)], (std::array{TriangleId(0), TriangleId(), TriangleId()}));
}

TEST(TriangleNeighbors, AgreeWithCountingFromScratch) {
  TriangleMesh repeating = gallery::tetrahedron();
  repeating.triangles.push_back({VertexId(0), VertexId(0), VertexId(1)});
  const TriangleMesh soup_of_few_vertices = [] {
    TriangleMesh mesh;
    mesh.points.resize(9);
    std::mt19937 generator(7);
    for (int t = 0; t < 60; ++t) {  // many overfull edges, repeated vertices and duplicates
      mesh.triangles.push_back({VertexId(static_cast<std::uint32_t>(generator() % 8)),
                                VertexId(static_cast<std::uint32_t>(generator() % 8)),
                                VertexId(static_cast<std::uint32_t>(generator() % 8))});
    }
    return mesh;
  }();
  for (const TriangleMesh& mesh :
       {gallery::cube(), gallery::open_patch(3, 4), gallery::torus(7, 5), gallery::moebius_strip(5),
        gallery::two_tetrahedra_sharing_an_edge(), gallery::two_tetrahedra_sharing_a_vertex(),
        gallery::shuffled(gallery::sphere(2), 3), gallery::random_soup(200, 3), repeating,
        soup_of_few_vertices, TriangleMesh{}}) {
    expect_right(mesh);
  }
}

TEST(TriangleNeighbors, AnOverfullEdgeHasNoneButAllHalfedges) {
  const TriangleMesh mesh = gallery::two_tetrahedra_sharing_an_edge();
  const TriangleNeighbors neighbors = triangle_neighbors(mesh);
  const HalfedgeRings rings = link_halfedges(mesh);
  std::size_t at_shared = 0;
  for (Halfedge h = 0; h < rings.links.size(); ++h) {
    const auto [a, b] = ends_of_halfedge(mesh, h);
    if (std::set{a, b} != std::set{VertexId(0), VertexId(1)}) continue;
    ++at_shared;
    EXPECT_TRUE(neighbors[TriangleId(triangle_of_halfedge(h))][corner_of_halfedge(h)].is_none());
  }
  EXPECT_EQ(at_shared, 4U);
}

TEST(TriangleNeighbors, ATriangleThatRepeatsAVertexHasNone) {
  const TriangleMesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 1}, {2, 2, 2}});
  const TriangleNeighbors neighbors = triangle_neighbors(mesh);
  for (const TriangleId t : mesh.triangles.ids()) {
    EXPECT_EQ(neighbors[t], (std::array<TriangleId, 3>{}));
  }
}

TEST(TriangleNeighbors, RefuseATriangleThatNamesAMissingVertex) {
  TriangleMesh mesh = gallery::tetrahedron();
  mesh.triangles[TriangleId(2)][1] = VertexId(4);
  EXPECT_THROW(triangle_neighbors(mesh), InputError);
}

}  // namespace
}  // namespace cocoon
