#include "cocone/ball_cosines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "delaunay/voronoi_dual.h"

namespace cocoon {

BallCosines::BallCosines(const Triangulation& triangulation)
    : triangulation_(triangulation),
      cosines_(triangulation.num_cells()),
      known_(triangulation.num_cells()) {}

void BallCosines::prepare(std::span<const CellId> cells, const Execution& execution) {
  constexpr std::size_t cells_per_chunk = 4096;
  parallel_chunks(execution, cells.size(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for_each_center(triangulation_, cells.subspan(begin, end - begin),
                                    [&](CellId c, const Point& center) {
                                      cosines_[c] = compute(c, center);
                                      known_[c] = 1;
                                    });
                  });
}

double BallCosines::of(FacetId f) {
  const CellId c = cell_of(f);
  if (triangulation_.is_infinite(c)) return 1;
  if (known_[c] == 0) {
    cosines_[c] = compute(c, voronoi_vertex(triangulation_, c));
    known_[c] = 1;
  }
  return cosines_[c][static_cast<std::size_t>(index_of(f))];
}

double BallCosines::contact(FacetId f) {
  // beta = pi - phi - psi: cos(beta) = -cos(phi + psi) = sin phi sin psi - cos phi cos psi
  const double phi = of(f);
  const double psi = of(triangulation_.mirror(f));
  const double sines = std::sqrt((1 - phi * phi) * (1 - psi * psi));
  return sines - phi * psi;
}

std::array<double, 4> BallCosines::compute(CellId c, const Point& center) const {
  struct Corner {
    Point point;
    std::size_t index;
  };
  std::array<Corner, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {triangulation_.point(triangulation_.cell(c).vertices[i]), i};
  }
  const auto order = [&](std::size_t i, std::size_t j) {
    if (corners[j].point < corners[i].point) std::swap(corners[i], corners[j]);
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  const double radius = norm(center - corners[0].point);
  std::array<double, 4> cosines{};
  for (std::size_t k = 0; k < 4; ++k) {  // the facet opposite the k-th corner
    const Point& p = corners[k < 1 ? 1 : 0].point;
    const Vec3 normal = cross(corners[k < 2 ? 2 : 1].point - p, corners[k < 3 ? 3 : 2].point - p);
    const double lengths = norm(normal) * radius;
    if (!(lengths > 0) || !std::isfinite(lengths)) continue;
    const double cosine = dot(normal, center - p) / lengths;
    const bool apex_above = dot(normal, corners[k].point - p) > 0;
    cosines[corners[k].index] = std::clamp(apex_above ? cosine : -cosine, -1.0, 1.0);
  }
  return cosines;
}

}  // namespace cocoon
