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
                      std::size_t edges, SpacingBuffers& buffers) {
  auto& [around, squares] = buffers;
  collect_neighbors(triangulation, star, v, around);
  squares.clear();
  for (const VertexId w : around) {
    squares.push_back(squared_distance(triangulation.point(v), triangulation.point(w)));
  }
  std::sort(squares.begin(), squares.end());
  squares.resize(std::min(squares.size(), std::max<std::size_t>(1, edges)));
  double sum = 0;
  for (const double square : squares) sum += square;
  return std::sqrt(sum / static_cast<double>(squares.size()));
}

bool is_outlying(double spacing, double ratio, std::vector<double>& spacings_around) {
  const auto middle =
      spacings_around.begin() + static_cast<std::ptrdiff_t>(spacings_around.size() / 2);
  std::nth_element(spacings_around.begin(), middle, spacings_around.end());
  return spacing > ratio * *middle;
}

double OutlierTest::spacing(VertexId v) {
  if (spacing_[v] == 0) {
    spacing_[v] = sample_spacing(triangulation_, stars_.star(v), v, edges, buffers_);
  }
  return spacing_[v];
}

bool OutlierTest::is_outlier(VertexId v) {
  std::vector<VertexId> around;
  collect_neighbors(triangulation_, stars_.star(v), v, around);
  std::vector<double> spacings;
  spacings.reserve(around.size());
  for (const VertexId w : around) spacings.push_back(spacing(w));
  return is_outlying(spacing(v), ratio_, spacings);
}

}  // namespace cocoon
