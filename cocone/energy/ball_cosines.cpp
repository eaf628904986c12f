#include "cocone/energy/ball_cosines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cocone/energy/facet_cosines.h"
#include "cocone/facets/cell_order.h"
#include "cocone/facets/facet_normal.h"
#include "delaunay/voronoi/cell_blocks.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

BallCosines::BallCosines(const Triangulation& triangulation, double flat_ratio)
    : triangulation_(triangulation),
      flat_ratio_(flat_ratio),
      cosines_(triangulation.num_cells()),
      known_(triangulation.num_cells()),
      ends_(triangulation.num_cells()) {}

ZeroedArray<CellId, Point> BallCosines::prepare(std::span<const CellId> cells,
                                                const Execution& execution) {
  constexpr std::size_t cells_per_chunk = 4096;
  ZeroedArray<CellId, Point> centers(triangulation_.num_cells());
  parallel_chunks(execution, cells.size(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    compute(cells.subspan(begin, end - begin),
                            [&](CellId c, const Point& center) { centers[c] = center; });
                  });
  return centers;
}

BallCosines::Known BallCosines::ask(CellId c) {
  compute(std::span(&c, 1), [](CellId, const Point&) {});
  return known_[c];
}

// Tells the centers, too.
template <class Visit>
void BallCosines::compute(std::span<const CellId> cells, Visit visit) {
  FacetCosines found;
  for_each_block(triangulation_, cells, [&](std::span<const CellId> finite, CellBlock& block) {
    facet_cosines(block, flat_ratio_, found);
    for (std::size_t k = 0; k < finite.size(); ++k) {
      const CellId c = finite[k];
      for (std::size_t j = 0; j < 4; ++j) cosines_[c][j] = found.at(k, j);
      known_[c] = found.flat[k] != 0 ? Known::flat : Known::cosines;
      visit(c, block.center(k));
    }
  });
}

double BallCosines::contact(FacetId f) {
  // beta = pi - phi - psi: cos(beta) = -cos(phi + psi) = sin phi sin psi - cos phi cos psi
  const double phi = of(f);
  const double psi = of(triangulation_.mirror(f));
  const double sines = std::sqrt((1 - phi * phi) * (1 - psi * psi));
  return sines - phi * psi;
}

// For whom enters the flat cell of f by f.
CellId BallCosines::through(FacetId f) {
  passed_.clear();
  std::uint32_t end = not_asked;
  while (end == not_asked) {
    const CellId c = cell_of(f);
    if (!is_flat(c)) {
      end = first_end + c.value;
      break;
    }
    std::uint32_t& known = ends_[c][static_cast<std::size_t>(index_of(f))];
    end = std::exchange(known, known == not_asked ? nowhere : known);
    passed_.push_back(f);
    f = triangulation_.mirror(facet_id(c, far_side(f)));
  }
  for (const FacetId g : passed_) ends_[cell_of(g)][static_cast<std::size_t>(index_of(g))] = end;
  return end == nowhere ? CellId() : CellId(end - first_end);
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
