#include "geom/mesh_adjacency.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

#include "geom/errors.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using gallery::make_mesh;

// Compares every list of the adjacency with one counted from scratch.
void expect_right(const TriangleMesh& mesh, const MeshAdjacency& adjacency) {
  std::map<std::array<VertexId, 2>, std::vector<HalfedgeId>> sides;
  std::map<VertexId, std::set<TriangleId>> at_vertex;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& tri = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      at_vertex[tri[static_cast<std::size_t>(i)]].insert(t);
      const auto [from, to] = ends_of(mesh, halfedge_of(t, i));
      if (std::set<VertexId>(tri.begin(), tri.end()).size() < 3) continue;
      sides[{std::min(from, to), std::max(from, to)}].push_back(halfedge_of(t, i));
    }
  }
  ASSERT_EQ(adjacency.edges.size(), sides.size());
  EdgeId edge(0);
  for (const auto& [ends, expected] : sides) {
    EXPECT_EQ(adjacency.edges[edge], ends);
    EXPECT_EQ(adjacency.edge_between(ends[1], ends[0]), edge);
    const auto actual = adjacency.halfedges_at(edge);
    EXPECT_EQ(std::vector<HalfedgeId>(actual.begin(), actual.end()), expected);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(adjacency.edge_of[expected[k]], edge);
      const TriangleId across = expected.size() == 2 ? triangle_of(expected[1 - k]) : TriangleId();
      EXPECT_EQ(adjacency.neighbors[triangle_of(expected[k])]
                                   [static_cast<std::size_t>(corner_of(expected[k]))],
                across);
    }
    ++edge;
  }
  for (const VertexId v : mesh.points.ids()) {
    const auto actual = adjacency.triangles_at(v);
    const std::set<TriangleId>& expected = at_vertex[v];
    EXPECT_TRUE(std::equal(actual.begin(), actual.end(), expected.begin(), expected.end()));
  }
}

TEST(MeshAdjacency, TetrahedronHasEveryTriangleBesideEveryOther) {
  const TriangleMesh mesh = gallery::tetrahedron();
  const MeshAdjacency adjacency = mesh_adjacency(mesh);
  EXPECT_EQ(adjacency.edges.size(), 6U);
  for (const TriangleId t : mesh.triangles.ids()) {
    std::set<TriangleId> around(adjacency.neighbors[t].begin(), adjacency.neighbors[t].end());
    EXPECT_EQ(around.size(), 3U);
    EXPECT_EQ(around.count(t), 0U);
    EXPECT_EQ(around.count(TriangleId()), 0U);
  }
  for (const VertexId v : mesh.points.ids()) EXPECT_EQ(adjacency.triangles_at(v).size(), 3U);
}

TEST(MeshAdjacency, SidesAreOppositeTheirCorner) {
  const TriangleMesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {3, 2, 1}});
  EXPECT_EQ(ends_of(mesh, halfedge_of(TriangleId(0), 0)), (std::array{VertexId(1), VertexId(2)}));
  EXPECT_EQ(ends_of(mesh, halfedge_of(TriangleId(0), 1)), (std::array{VertexId(2), VertexId(0)}));
  const MeshAdjacency adjacency = mesh_adjacency(mesh);
  EXPECT_EQ(adjacency.neighbors[TriangleId(0)],
            (std::array{TriangleId(1), TriangleId(), TriangleId()}));
  EXPECT_EQ(adjacency.neighbors[TriangleId(1)],
            (std::array{TriangleId(0), TriangleId(), TriangleId()}));
}

TEST(MeshAdjacency, AgreesWithCountingFromScratch) {
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
        gallery::shuffled(gallery::sphere(2), 3), soup_of_few_vertices, TriangleMesh{}}) {
    expect_right(mesh, mesh_adjacency(mesh));
  }
}

TEST(MeshAdjacency, OverfullEdgeHasNoNeighborButListsItsSides) {
  const TriangleMesh mesh = gallery::two_tetrahedra_sharing_an_edge();
  const MeshAdjacency adjacency = mesh_adjacency(mesh);
  const EdgeId shared = adjacency.edge_between(VertexId(0), VertexId(1));
  ASSERT_FALSE(shared.is_none());
  ASSERT_EQ(adjacency.halfedges_at(shared).size(), 4U);
  for (const HalfedgeId side : adjacency.halfedges_at(shared)) {
    EXPECT_TRUE(adjacency.neighbors[triangle_of(side)][static_cast<std::size_t>(corner_of(side))]
                    .is_none());
  }
}

TEST(MeshAdjacency, TriangleThatRepeatsAVertexHasNoEdges) {
  const TriangleMesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 1}, {2, 2, 2}});
  const MeshAdjacency adjacency = mesh_adjacency(mesh);
  EXPECT_EQ(adjacency.edges.size(), 3U);
  EXPECT_TRUE(adjacency.edge_of[halfedge_of(TriangleId(1), 2)].is_none());
  EXPECT_EQ(adjacency.triangles_at(VertexId(1)).size(), 2U);
  EXPECT_EQ(adjacency.triangles_at(VertexId(2)).size(), 2U);
}

TEST(MeshAdjacency, NeighborsAloneAreTheSame) {
  TriangleMesh repeating = gallery::tetrahedron();
  repeating.triangles.push_back({VertexId(0), VertexId(0), VertexId(1)});
  for (const TriangleMesh& mesh :
       {gallery::sphere(3), gallery::open_patch(4, 5), gallery::two_tetrahedra_sharing_an_edge(),
        gallery::two_tetrahedra_sharing_a_vertex(), gallery::moebius_strip(9),
        gallery::random_soup(200, 3), repeating, TriangleMesh{}}) {
    const MeshAdjacency whole = mesh_adjacency(mesh);
    const MeshAdjacency lean = mesh_neighbors(mesh);
    EXPECT_TRUE(lean.neighbors == whole.neighbors);
    EXPECT_EQ(lean.vertex_begin, whole.vertex_begin);
    EXPECT_EQ(lean.vertex_triangles, whole.vertex_triangles);
  }
}

TEST(MeshAdjacency, NoEdgeBetweenStrangers) {
  const MeshAdjacency adjacency = mesh_adjacency(gallery::open_patch(2, 2));
  EXPECT_TRUE(adjacency.edge_between(VertexId(0), VertexId(8)).is_none());
  EXPECT_TRUE(adjacency.edge_between(VertexId(4), VertexId(4)).is_none());
}

TEST(MeshAdjacency, RefusesATriangleThatNamesAMissingVertex) {
  TriangleMesh mesh = gallery::tetrahedron();
  mesh.triangles[TriangleId(2)][1] = VertexId(4);
  EXPECT_THROW(mesh_adjacency(mesh), InputError);
}

}  // namespace
}  // namespace cocoon
