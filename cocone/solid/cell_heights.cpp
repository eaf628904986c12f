#include "cocone/solid/cell_heights.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "cocone/facets/cell_order.h"

namespace cocoon {
namespace {

// Both ends, in one word.
using Edge = std::uint64_t;
VertexId from(Edge edge) { return VertexId(static_cast<std::uint32_t>(edge >> 32)); }
VertexId to(Edge edge) { return VertexId(static_cast<std::uint32_t>(edge)); }

// In the order of their ends as points: of two that reach equally far the first one counts.
std::array<Edge, 6> edges_of(const Triangulation& triangulation, CellId c) {
  std::array<VertexId, 4> corners = triangulation.cell(c).vertices;
  std::sort(corners.begin(), corners.end(), [&](VertexId a, VertexId b) {
    return triangulation.point(a) < triangulation.point(b);
  });
  std::array<Edge, 6> edges;
  std::size_t count = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      edges[count++] = Edge{corners[k].value} << 32 | corners[i].value;
    }
  }
  return edges;
}

// Each once, in increasing order of these words.
std::vector<Edge> edges_of(const Triangulation& triangulation, std::span<const CellId> cells) {
  std::vector<Edge> edges;
  edges.reserve(6 * cells.size());
  for (const CellId c : cells) {
    const std::array<Edge, 6> of_cell = edges_of(triangulation, c);
    edges.insert(edges.end(), of_cell.begin(), of_cell.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

Point middle_of(const Triangulation& triangulation, Edge edge) {
  return 0.5 * (triangulation.point(from(edge)) + triangulation.point(to(edge)));
}

double length_of(const Triangulation& triangulation, Edge edge) {
  return distance(triangulation.point(from(edge)), triangulation.point(to(edge)));
}

void take_in(double height, const Point& place, CellHeights& heights) {
  if (height < heights.lowest) {
    heights.lowest = height;
    heights.at_lowest = place;
  }
  if (height > heights.highest) {
    heights.highest = height;
    heights.at_highest = place;
  }
}

// The longest edge, and how far the middles of edges are from the centroid.
CentroidHeight with_sizes(const Triangulation& triangulation, CellId c, double height,
                          const Point& centroid) {
  CentroidHeight cell{height, 0, 0};
  for (const Edge edge : edges_of(triangulation, c)) {
    cell.longest_edge = std::max(cell.longest_edge, length_of(triangulation, edge));
    cell.farthest_middle =
        std::max(cell.farthest_middle, distance(centroid, middle_of(triangulation, edge)));
  }
  return cell;
}

// Takes in the middles of the edges of cells[k], for each k of `open`.
void add_edges(const Triangulation& triangulation, std::span<const CellId> cells,
               const std::vector<std::size_t>& open, const SolidDistances& solid,
               std::vector<CellHeights>& heights, const Execution& execution) {
  std::vector<CellId> open_cells;
  open_cells.reserve(open.size());
  for (const std::size_t k : open) open_cells.push_back(cells[k]);
  // An edge belongs to five cells in the mean: its middle is asked about once.
  const std::vector<Edge> edges = edges_of(triangulation, open_cells);
  std::vector<Point> middles;
  middles.reserve(edges.size());
  for (const Edge edge : edges) middles.push_back(middle_of(triangulation, edge));
  const std::vector<double> distances = solid.at(middles, execution);
  for (const std::size_t k : open) {
    for (const Edge edge : edges_of(triangulation, cells[k])) {
      const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
      const auto place = static_cast<std::size_t>(found - edges.begin());
      take_in(distances[place], middles[place], heights[k]);
    }
  }
}

}  // namespace

Point centroid_of(const Triangulation& triangulation, CellId c) {
  const auto [p0, p1, p2, p3] = sorted_corners(triangulation, c);
  return 0.25 * ((p0 + p1) + (p2 + p3));
}

std::vector<CellHeights> cell_heights(const Triangulation& triangulation,
                                      std::span<const CellId> cells, const SolidDistances& solid,
                                      CellPlaces places, const IsSettled& is_settled,
                                      const Execution& execution) {
  std::vector<Point> centroids;
  centroids.reserve(cells.size());
  for (const CellId c : cells) centroids.push_back(centroid_of(triangulation, c));
  const std::vector<double> distances = solid.at(centroids, execution);

  std::vector<CellHeights> heights(cells.size());
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    CellHeights& cell = heights[k];
    cell.at_lowest = cell.at_highest = centroids[k];
    take_in(distances[k], centroids[k], cell);
    const CentroidHeight middle = with_sizes(triangulation, cells[k], distances[k], centroids[k]);
    cell.longest_edge = middle.longest_edge;
    if (places == CellPlaces::centroid) continue;
    if (!is_settled || !is_settled(middle)) open.push_back(k);
  }
  if (!open.empty()) add_edges(triangulation, cells, open, solid, heights, execution);
  return heights;
}

}  // namespace cocoon
