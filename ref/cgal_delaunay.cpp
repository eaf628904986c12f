#include "ref/cgal_delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <array>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "ref/triangulation_of_cells.h"

namespace cocoon::ref {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexId, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using DataStructure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, DataStructure>;

// Each point carries its vertex id through CGAL. A range of points is inserted in spatial order.
Delaunay build(const IdVector<VertexId, Point>& points) {
  std::vector<std::pair<Kernel::Point_3, VertexId>> labeled;
  labeled.reserve(points.size());
  for (const VertexId v : points.ids()) {
    const Point& p = points[v];
    labeled.emplace_back(Kernel::Point_3(p.x, p.y, p.z), v);
  }
  Delaunay delaunay;
  delaunay.insert(labeled.begin(), labeled.end());
  return delaunay;
}

}  // namespace

Triangulation cgal_delaunay(Points points) {
  DistinctPoints distinct = distinct_points(points);
  const Delaunay delaunay = build(distinct.points);
  if (delaunay.dimension() < 3) {
    throw InputError("all points lie in one plane: no triangulation of space");
  }
  // CGAL's cells have the project's orientation already.
  std::vector<std::array<VertexId, 4>> cells;
  cells.reserve(delaunay.number_of_finite_cells());
  for (const auto& cell : delaunay.finite_cell_handles()) {
    cells.push_back({cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
                     cell->vertex(3)->info()});
  }
  return triangulation_of_cells(std::move(distinct), std::move(cells));
}

}  // namespace cocoon::ref
