#include "delaunay/voronoi_cell.h"

#include <algorithm>

#include "delaunay/circulate.h"
#include "delaunay/point_queries.h"

namespace cocoon {
namespace {

bool is_even_permutation(const std::array<int, 4>& slots) {
  int inversions = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) inversions += slots[i] > slots[j] ? 1 : 0;
  }
  return inversions % 2 == 0;
}

// The facet of c at the edge from v to w from which the rotation about the edge crosses c
// counterclockwise, seen from w: for orient3d(v, w, x, y) > 0 that is from vwx to vwy.
FacetId counterclockwise_start(const Cell& cell, CellId c, VertexId v, VertexId w) {
  const int at_v = index_of_vertex(cell, v);
  const int at_w = index_of_vertex(cell, w);
  int x = 0;
  while (x == at_v || x == at_w) ++x;
  const int y = 6 - at_v - at_w - x;
  return facet_id(c, is_even_permutation({at_v, at_w, x, y}) ? y : x);
}

}  // namespace

VoronoiCell voronoi_cell(const TriangulationView& triangulation, VertexId v, CellId cell) {
  struct Edge {
    VertexId neighbor;
    CellId cell;
  };
  std::vector<Edge> edges;
  VoronoiCell result;
  for (const CellId c : star_of_vertex(triangulation, v, cell)) {
    if (triangulation.is_infinite(c)) result.is_bounded = false;
    for (const VertexId w : triangulation.cell(c).vertices) {
      if (w != v && w != infinite_vertex) edges.push_back({w, c});
    }
  }
  // The first cell at each edge is the one of the smallest id: the rotation begins there.
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.neighbor != b.neighbor ? a.neighbor < b.neighbor : a.cell < b.cell;
  });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [w, c] = edges[i];
    if (i > 0 && edges[i - 1].neighbor == w) continue;
    VoronoiFace face{w, {}};
    for_each_facet_around_edge(triangulation,
                               counterclockwise_start(triangulation.cell(c), c, v, w), v, w,
                               [&](FacetId f) { face.corners.push_back(cell_of(f)); });
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace cocoon
