#include "geom/mesh_adjacency.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "geom/large_pages.h"
#include "geom/side_links.h"
#include "geom/sort_by_vertex.h"

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

// All sides, grouped by their smaller vertex, each group sorted by (larger vertex,
// halfedge): the sides at one edge are consecutive.
std::vector<Side> sorted_sides(const TriangleMesh& mesh, std::vector<std::uint32_t>& begin) {
  std::vector<Side> sides;
  begin = sort_by_vertex(
      mesh.triangles.size(), mesh.points.size(), Execution{},
      [&](std::size_t count) { sides.resize(count); },
      [&](std::size_t first, std::size_t end, auto put) {
        for (TriangleId t(first); t.index() < end; ++t) {
          if (repeats_a_vertex(mesh.triangles[t])) continue;
          for (int i = 0; i < 3; ++i) {
            const std::array<VertexId, 2> ends = ends_of(mesh, halfedge_of(t, i));
            put(std::min(ends[0], ends[1]), [&](std::uint32_t place) {
              sides[place] = Side(std::max(ends[0], ends[1]), halfedge_of(t, i));
            });
          }
        }
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
  std::vector<TriangleId>& listed = adjacency.vertex_triangles;
  adjacency.vertex_begin = sort_by_vertex(
      mesh.triangles.size(), mesh.points.size(), Execution{},
      [&](std::size_t count) {
        listed.clear();
        listed.reserve(count);
        prefer_large_pages(listed);
        listed.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (TriangleId t(begin); t.index() < end; ++t) {
          const auto write = [&](std::uint32_t place) { listed[place] = t; };
          const Triangle& corners = mesh.triangles[t];  // equal ones count once
          put(corners[0], write);
          if (corners[1] != corners[0]) put(corners[1], write);
          if (corners[2] != corners[0] && corners[2] != corners[1]) put(corners[2], write);
        }
      });
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
  const SideLinks links = side_links(mesh.triangles.span(), mesh.points.size());
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
