#include "geom/mesh_adjacency.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "geom/large_pages.h"
#include "geom/side_links.h"

namespace cocoon {
namespace {

// (larger vertex, halfedge) in one word, which sorts as the pair does.
class Side {
 public:
  Side() = default;
  Side(VertexId larger, HalfedgeId halfedge)
      : word_(std::uint64_t{larger.value} << 32 | halfedge.value) {}
  VertexId larger() const { return VertexId(static_cast<std::uint32_t>(word_ >> 32)); }
  HalfedgeId halfedge() const { return HalfedgeId(static_cast<std::uint32_t>(word_)); }
  friend auto operator<=>(const Side&, const Side&) = default;

 private:
  std::uint64_t word_ = 0;
};

// All sides, grouped by their smaller vertex (bucket sort), each group sorted by (larger vertex,
// halfedge): the sides at one edge are consecutive.
std::vector<Side> sorted_sides(const TriangleMesh& mesh, std::vector<std::uint32_t>& begin) {
  begin.assign(mesh.points.size() + 1, 0);
  const auto for_each_side = [&mesh](const auto& visit) {
    for (const TriangleId t : mesh.triangles.ids()) {
      if (repeats_a_vertex(mesh.triangles[t])) continue;
      for (int i = 0; i < 3; ++i) {
        const auto [from, to] = ends_of(mesh, halfedge_of(t, i));
        visit(std::min(from, to), std::max(from, to), halfedge_of(t, i));
      }
    }
  };
  for_each_side([&](VertexId smaller, VertexId, HalfedgeId) { ++begin[smaller.index() + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(begin.back());
  std::vector<std::uint32_t> next = begin;
  for_each_side([&](VertexId smaller, VertexId larger, HalfedgeId h) {
    sides[next[smaller.index()]++] = Side(larger, h);
  });
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1]);
  }
  return sides;
}

void list_sides_at_edges(const TriangleMesh& mesh, MeshAdjacency& adjacency) {
  std::vector<std::uint32_t> begin;
  const std::vector<Side> sides = sorted_sides(mesh, begin);
  adjacency.edge_of.resize(3 * mesh.triangles.size());
  adjacency.edge_halfedges.reserve(sides.size());
  adjacency.edges.reserve(sides.size() / 2);
  adjacency.edge_begin.reserve(sides.size() / 2 + 1);
  for (const VertexId smaller : mesh.points.ids()) {
    VertexId larger;
    for (std::size_t k = begin[smaller.index()]; k < begin[smaller.index() + 1]; ++k) {
      if (sides[k].larger() != larger) {
        larger = sides[k].larger();
        adjacency.edge_begin.push_back(static_cast<std::uint32_t>(k));
        adjacency.edges.push_back({smaller, larger});
      }
      adjacency.edge_halfedges.push_back(sides[k].halfedge());
      adjacency.edge_of[sides[k].halfedge()] = EdgeId(adjacency.edges.size() - 1);
    }
  }
  adjacency.edge_begin.push_back(static_cast<std::uint32_t>(sides.size()));
}

void link_neighbors(MeshAdjacency& adjacency) {
  for (const EdgeId edge : adjacency.edges.ids()) {
    const std::span<const HalfedgeId> sides = adjacency.halfedges_at(edge);
    if (sides.size() != 2) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto corner = static_cast<std::size_t>(corner_of(sides[k]));
      adjacency.neighbors[triangle_of(sides[k])][corner] = triangle_of(sides[1 - k]);
    }
  }
}

}  // namespace

void list_triangles_at_vertices(const TriangleMesh& mesh, MeshAdjacency& adjacency) {
  // Calls visit(vertex, triangle) for each corner, equal ones of a triangle once.
  const auto for_each_corner = [&mesh](const auto& visit) {
    for (const TriangleId t : mesh.triangles.ids()) {
      const auto [a, b, c] = mesh.triangles[t];
      visit(a, t);
      if (b != a) visit(b, t);
      if (c != a && c != b) visit(c, t);
    }
  };
  // The begin of list v stands at place v + 1 until all triangles before it are listed.
  std::vector<std::uint32_t>& begin = adjacency.vertex_begin;
  begin.assign(mesh.points.size() + 2, 0);
  for_each_corner([&](VertexId v, TriangleId) { ++begin[v.index() + 2]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<TriangleId>& listed = adjacency.vertex_triangles;
  listed.clear();
  listed.reserve(begin.back());
  prefer_large_pages(listed);
  listed.resize(begin.back());
  for_each_corner([&](VertexId v, TriangleId t) { listed[begin[v.index() + 1]++] = t; });
  begin.pop_back();
}

std::span<const HalfedgeId> MeshAdjacency::halfedges_at(EdgeId edge) const {
  const std::size_t begin = edge_begin[edge.index()];
  return {edge_halfedges.data() + begin, edge_begin[edge.index() + 1] - begin};
}

std::span<const TriangleId> MeshAdjacency::triangles_at(VertexId vertex) const {
  const std::size_t begin = vertex_begin[vertex.index()];
  return {vertex_triangles.data() + begin, vertex_begin[vertex.index() + 1] - begin};
}

EdgeId MeshAdjacency::edge_between(VertexId a, VertexId b) const {
  const std::array<VertexId, 2> wanted = {std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(edges.begin(), edges.end(), wanted);
  if (found == edges.end() || *found != wanted) return {};
  return EdgeId(static_cast<std::size_t>(found - edges.begin()));
}

MeshAdjacency mesh_adjacency(const TriangleMesh& mesh) {
  require_valid_triangles(mesh);
  MeshAdjacency adjacency;
  adjacency.neighbors.resize(mesh.triangles.size());
  list_triangles_at_vertices(mesh, adjacency);
  list_sides_at_edges(mesh, adjacency);
  link_neighbors(adjacency);
  return adjacency;
}

IdVector<TriangleId, std::array<TriangleId, 3>> neighbors_across_sides(const TriangleMesh& mesh) {
  require_valid_triangles(mesh);
  IdVector<TriangleId, std::array<TriangleId, 3>> neighbors;
  neighbors.reserve(mesh.triangles.size());
  prefer_large_pages(neighbors.raw());
  neighbors.resize(mesh.triangles.size());
  const std::vector<SideId> links = side_links(mesh.triangles.span(), mesh.points.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side = static_cast<SideId>(3 * t.index() + i);
      const SideId other = links[side];
      if (other == side || links[other] != side) continue;
      neighbors[t][i] = TriangleId(triangle_of_side(other));
    }
  }
  return neighbors;
}

MeshAdjacency mesh_neighbors(const TriangleMesh& mesh) {
  if (std::any_of(mesh.triangles.begin(), mesh.triangles.end(), repeats_a_vertex)) {
    return mesh_adjacency(mesh);
  }
  MeshAdjacency adjacency;
  adjacency.neighbors = neighbors_across_sides(mesh);
  list_triangles_at_vertices(mesh, adjacency);
  return adjacency;
}

}  // namespace cocoon
