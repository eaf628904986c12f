#include "cocone/ball_cosines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cocone/cell_order.h"
#include "cocone/facet_normal.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

BallCosines::BallCosines(const Triangulation& triangulation, double flat_ratio)
    : triangulation_(triangulation),
      flat_ratio_(flat_ratio),
      cosines_(triangulation.num_cells()),
      known_(triangulation.num_cells()) {}

ZeroedArray<CellId, Point> BallCosines::prepare(std::span<const CellId> cells,
                                                const Execution& execution) {
  constexpr std::size_t cells_per_chunk = 4096;
  ZeroedArray<CellId, Point> centers(triangulation_.num_cells());
  parallel_chunks(execution, cells.size(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for_each_center(triangulation_, cells.subspan(begin, end - begin),
                                    [&](CellId c, const Point& center) {
                                      centers[c] = center;
                                      compute(c, center);
                                    });
                  });
  return centers;
}

BallCosines::Known BallCosines::ask(CellId c) {
  compute(c, voronoi_vertex(triangulation_, c));
  return known_[c];
}

double BallCosines::contact(FacetId f) {
  // beta = pi - phi - psi: cos(beta) = -cos(phi + psi) = sin phi sin psi - cos phi cos psi
  const double phi = of(f);
  const double psi = of(triangulation_.mirror(f));
  const double sines = std::sqrt((1 - phi * phi) * (1 - psi * psi));
  return sines - phi * psi;
}

void BallCosines::compute(CellId c, const Point& center) {
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
  std::array<double, 4>& cosines = cosines_[c];
  double largest = 0;                    // twice the area of a facet
  double volume = 0;                     // six times that of the cell
  for (std::size_t k = 0; k < 4; ++k) {  // the facet opposite the k-th corner
    const Point& p = corners[k < 1 ? 1 : 0].point;
    const Vec3 normal = cross(corners[k < 2 ? 2 : 1].point - p, corners[k < 3 ? 3 : 2].point - p);
    const double area = norm(normal);
    const double height = dot(normal, corners[k].point - p);
    if (area > largest) {
      largest = area;
      volume = std::abs(height);
    }
    const double lengths = area * radius;
    if (!(lengths > 0) || !std::isfinite(lengths)) continue;
    const double cosine = dot(normal, center - p) / lengths;
    cosines[corners[k].index] = std::clamp(height > 0 ? cosine : -cosine, -1.0, 1.0);
  }
  const bool flat = flat_ratio_ > 0 && volume <= flat_ratio_ * largest * std::sqrt(largest);
  known_[c] = flat ? Known::flat : Known::cosines;
}

// For whom enters the flat cell of f by f.
CellId BallCosines::through(FacetId f) {
  for (int passed = 0; passed < max_flat_cells; ++passed) {
    const CellId c = cell_of(f);
    if (!is_flat(c)) return c;
    f = triangulation_.mirror(facet_id(c, far_side(f)));
  }
  return {};
}

// By which the facets of a cell compare: the area; ties by the vertex that they do not have.
std::pair<double, Point> BallCosines::size_in_cell(FacetId f) const {
  return {squared_norm(outward_normal(triangulation_, f)),
          triangulation_.point(triangulation_.vertex(cell_of(f), index_of(f)))};
}

// Of the facets of a flat cell that face the other way than f the largest. If f alone is so
// degenerate that none faces the other way: of all others.
int BallCosines::far_side(FacetId f) const {
  const CellId c = cell_of(f);
  const Vec3 entered = outward_normal(triangulation_, f);
  const auto size = [&](int i) {
    const FacetId g = facet_id(c, i);
    return std::pair(dot(outward_normal(triangulation_, g), entered) < 0, size_in_cell(g));
  };
  int best = index_of(f) == 0 ? 1 : 0;
  for (int i = best + 1; i < 4; ++i) {
    if (i != index_of(f) && size(i) > size(best)) best = i;
  }
  return best;
}

std::array<CellId, 2> BallCosines::sides_of_flat(CellId c) {
  FacetId largest = facet_id(c, 0);
  for (int i = 1; i < 4; ++i) {
    if (size_in_cell(facet_id(c, i)) > size_in_cell(largest)) largest = facet_id(c, i);
  }
  return {through(largest), beyond(largest)};
}

void BallCosines::look_through(CellId c) {
  for (int i = 0; i < 4; ++i) {
    cosines_[c][static_cast<std::size_t>(i)] = cosine_through(facet_id(c, i));
  }
  known_[c] = Known::seen_through;
}

// For facet f of a flat cell, the ball of the cell that is seen through it.
double BallCosines::cosine_through(FacetId f) {
  const CellId seen = through(f);
  if (seen.is_none()) return 0;
  if (triangulation_.is_infinite(seen)) return 1;
  const Vec3 normal = outward_normal(triangulation_, f);
  const Point center = voronoi_vertex(triangulation_, seen);
  const Point corner = sorted_corners(triangulation_, f)[0];
  const double radius = norm(center - sorted_corners(triangulation_, seen)[0]);
  const double lengths = norm(normal) * radius;
  if (!(lengths > 0) || !std::isfinite(lengths)) return 0;
  return std::clamp(-dot(normal, center - corner) / lengths, -1.0, 1.0);
}

}  // namespace cocoon
