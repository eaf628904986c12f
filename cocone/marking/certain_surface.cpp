#include "cocone/marking/certain_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "cocone/cell_marks.h"
#include "geom/parallel/parallel_list.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

enum Umbrella : std::uint8_t { none = 0, good, folded };

VertexSet closed_umbrellas(const GoodVertices& vertices) {
  VertexSet umbrellas = vertices.good;
  for (const VertexId v : vertices.folded) umbrellas[v] = folded;
  return umbrellas;
}

bool are_at_all_vertices(const VertexSet& umbrellas, const LinkedFacets& triangles,
                         const Execution& execution) {
  return first_failing(execution, triangles.size(), [&](std::size_t t) {
           const auto [a, b, c] = triangles.corners[t];
           return umbrellas[a] != none && umbrellas[b] != none && umbrellas[c] != none;
         }) == triangles.size();
}

using Edge = std::array<VertexId, 2>;

// From both ends.
void append_folded_edges(const Triangle& triangle, const VertexSet& umbrellas,
                         std::vector<Edge>& edges) {
  const auto [a, b, c] = triangle;
  if (((umbrellas[a] | umbrellas[b] | umbrellas[c]) & folded) == 0) return;
  for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
    if (umbrellas[from] != folded || umbrellas[to] != folded) continue;
    edges.push_back({from, to});
    edges.push_back({to, from});
  }
}

// With two folded ends, from each of them; a set.
std::vector<Edge> folded_edges(const VertexSet& umbrellas, const LinkedFacets& triangles,
                               const Execution& execution) {
  std::vector<Edge> edges =
      parallel_list<Edge>(execution, triangles.size(), coarse_grain(triangles.size()),
                          [&](std::size_t begin, std::size_t end, std::vector<Edge>& found) {
                            for (std::size_t t = begin; t < end; ++t) {
                              append_folded_edges(triangles.corners[t], umbrellas, found);
                            }
                          });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool are_apart(const std::vector<Edge>& edges) {
  const auto neighbors = [&](VertexId v) {
    const auto less = [](const Edge& edge, const Edge& other) { return edge[0] < other[0]; };
    const auto [first, last] = std::equal_range(edges.begin(), edges.end(), Edge{v, v}, less);
    return last - first;
  };
  return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return neighbors(edge[0]) == 1 || neighbors(edge[1]) == 1;
  });
}

bool is_seen_from_outside(const Triangulation& triangulation, const ManifoldSurface& surface) {
  return std::any_of(surface.halves.begin(), surface.halves.end(),
                     [&](FacetId half) { return triangulation.is_infinite(cell_of(half)); });
}

bool no_cell_is_poor(const Triangulation& triangulation, const VertexSet& is_good,
                     const Execution& execution) {
  const std::size_t count = triangulation.num_finite_cells();
  return first_failing(execution, count, [&](std::size_t c) {
           return !is_poor(triangulation, is_good, CellId(c));
         }) == count;
}

}  // namespace

bool is_certain(const Triangulation& triangulation, const ManifoldSurface& surface,
                const GoodVertices& vertices, const Execution& execution) {
  if (surface.walks != 1 || surface.unwalked != 0) return false;
  if (!is_seen_from_outside(triangulation, surface)) return false;
  if (vertices.count == triangulation.num_vertices()) return true;
  const VertexSet umbrellas = closed_umbrellas(vertices);
  return are_at_all_vertices(umbrellas, surface.triangles, execution) &&
         are_apart(folded_edges(umbrellas, surface.triangles, execution)) &&
         no_cell_is_poor(triangulation, vertices.good, execution);
}

}  // namespace cocoon
