#include "ref/brute_force_delaunay.h"

#include <array>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"
#include "ref/triangulation_of_cells.h"

namespace cocoon::ref {
namespace {

using CellVertices = std::array<VertexId, 4>;

// Precondition: orient3d of the cell > 0.
bool is_in_sphere(const IdVector<VertexId, Point>& points, const CellVertices& cell, VertexId e) {
  const auto& [a, b, c, d] = cell;
  if (e == a || e == b || e == c || e == d) return false;
  return insphere_perturbed(points[a], points[b], points[c], points[d], points[e]) ==
         Sign::positive;
}

// Precondition: orient3d of the cell > 0.
bool has_empty_sphere(const IdVector<VertexId, Point>& points, const CellVertices& cell) {
  for (const VertexId e : points.ids()) {
    if (is_in_sphere(points, cell, e)) return false;
  }
  return true;
}

}  // namespace

Triangulation brute_force_delaunay(Points points) {
  DistinctPoints distinct = distinct_points(points);
  const IdVector<VertexId, Point>& p = distinct.points;
  const VertexId end(p.size());
  bool coplanar = true;
  std::vector<CellVertices> cells;
  for (VertexId a(0); a < end; ++a) {
    for (VertexId b(a.index() + 1); b < end; ++b) {
      for (VertexId c(b.index() + 1); c < end; ++c) {
        for (VertexId d(c.index() + 1); d < end; ++d) {
          const Sign orientation = orient3d(p[a], p[b], p[c], p[d]);
          if (orientation == Sign::zero) continue;
          coplanar = false;
          const CellVertices cell =
              orientation == Sign::positive ? CellVertices{a, b, c, d} : CellVertices{a, b, d, c};
          if (has_empty_sphere(p, cell)) cells.push_back(cell);
        }
      }
    }
  }
  if (coplanar) throw InputError("all points lie in one plane: no triangulation of space");
  return triangulation_of_cells(std::move(distinct), std::move(cells));
}

std::size_t occupied_pairs(const Triangulation& triangulation) {
  std::size_t pairs = 0;
  for (const CellId c : triangulation.finite_cells()) {
    for (const VertexId v : triangulation.vertices()) {
      if (is_in_sphere(triangulation.points(), triangulation.cell(c).vertices, v)) ++pairs;
    }
  }
  return pairs;
}

}  // namespace cocoon::ref
