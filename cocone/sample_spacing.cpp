#include "cocone/sample_spacing.h"

#include <algorithm>
#include <cmath>

namespace cocoon {

void collect_neighbors(const Triangulation& triangulation, std::span<const CellId> star, VertexId v,
                       std::vector<VertexId>& neighbors) {
  neighbors.clear();
  for (const CellId c : star) {
    for (const VertexId w : triangulation.cell(c).vertices) {
      if (w != v && w != infinite_vertex) neighbors.push_back(w);
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
}

double sample_spacing(const Triangulation& triangulation, std::span<const CellId> star, VertexId v,
                      std::size_t edges, SpacingBuffer& shortest) {
  const std::size_t count = std::max<std::size_t>(1, edges);
  shortest.clear();  // from now on in increasing order
  for (const CellId c : star) {
    for (const VertexId w : triangulation.cell(c).vertices) {
      if (w == v || w == infinite_vertex) continue;
      const double square = squared_distance(triangulation.point(v), triangulation.point(w));
      if (shortest.size() == count && !(square < shortest.back().square)) continue;
      const auto is_same = [&](const ShortEdge& edge) { return edge.to == w; };
      if (std::any_of(shortest.begin(), shortest.end(), is_same)) continue;
      const auto is_longer = [&](const ShortEdge& edge) { return square < edge.square; };
      const auto place = std::find_if(shortest.begin(), shortest.end(), is_longer);
      shortest.insert(place, {square, w});
      if (shortest.size() > count) shortest.pop_back();
    }
  }
  double sum = 0;
  for (const ShortEdge& edge : shortest) sum += edge.square;
  return std::sqrt(sum / static_cast<double>(shortest.size()));
}

double OutlierTest::spacing(VertexId v) {
  if (spacing_[v] == 0) {
    spacing_[v] = sample_spacing(triangulation_, stars_.star(v), v, edges, shortest_);
  }
  return spacing_[v];
}

bool OutlierTest::is_outlier(VertexId v) {
  collect_neighbors(triangulation_, stars_.star(v), v, around_);
  return is_outlying(spacing(v), ratio_, around_, [&](VertexId w) { return spacing(w); });
}

}  // namespace cocoon
