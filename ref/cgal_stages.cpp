#include "ref/cgal_stages.h"

#include <algorithm>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref {
namespace {

using namespace on_cgal;

std::array<PointId, 3> ids(const Facet& f) {
  std::array<PointId, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = PointId(corner(f, static_cast<int>(k))->info().id);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TightStages::Triangles surface_triangles(const Delaunay& delaunay) {
  TightStages::Triangles triangles;
  for (const Facet& f : delaunay.finite_facets()) {
    if (is_surface(f)) triangles.push_back(ids(f));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TightStages::Triangles between(const Delaunay& delaunay) {
  TightStages::Triangles triangles;
  for (const Facet& f : delaunay.finite_facets()) {
    const bool here = f.first->info().reached;
    if (here != f.first->neighbor(f.second)->info().reached) triangles.push_back(ids(f));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

template <class T>
IdVector<PointId, T> by_id(const Delaunay& delaunay, T VertexInfo::*member) {
  IdVector<PointId, T> result(delaunay.number_of_vertices());
  for (const VertexHandle v : delaunay.finite_vertex_handles()) {
    result[PointId(v->info().id)] = v->info().*member;
  }
  return result;
}

TightStages::Flags flags(const Delaunay& delaunay, bool VertexInfo::*member) {
  TightStages::Flags result(delaunay.number_of_vertices(), 0);
  for (const VertexHandle v : delaunay.finite_vertex_handles()) {
    result[PointId(v->info().id)] = v->info().*member ? 1 : 0;
  }
  return result;
}

std::array<PointId, 4> corners_of(const Delaunay& delaunay, CellHandle c) {
  std::array<PointId, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexHandle v = c->vertex(static_cast<int>(i));
    corners[i] = delaunay.is_infinite(v) ? PointId() : PointId(v->info().id);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

void choose_at_ties(const TightStages& chosen, const Delaunay& delaunay) {
  for (const VertexHandle v : delaunay.finite_vertex_handles()) {
    v->info().normal_at_ties = chosen.normals[PointId(v->info().id)];
  }
  for (const CellHandle c : delaunay.finite_cell_handles()) {
    const auto corners = corners_of(delaunay, c);
    const auto cell = std::lower_bound(
        chosen.cells.begin(), chosen.cells.end(), corners,
        [](const StagesCell& a, const std::array<PointId, 4>& b) { return a.corners < b; });
    if (cell == chosen.cells.end() || cell->corners != corners) continue;
    for (int i = 0; i < 4; ++i) {
      if (PointId(c->vertex(i)->info().id) == cell->stop) c->info().stop_facet_at_ties = i;
    }
  }
}

std::size_t ties_taken(const Delaunay& delaunay) {
  std::size_t count = 0;
  for (const VertexHandle v : delaunay.finite_vertex_handles()) count += v->info().took_tie;
  for (const CellHandle c : delaunay.finite_cell_handles()) count += c->info().took_tie;
  return count;
}

// After the marking; the rest follows the peel.
std::vector<StagesCell> marked_cells(const Delaunay& delaunay) {
  std::vector<StagesCell> cells;
  for (const CellHandle c : delaunay.all_cell_handles()) {
    cells.push_back(
        {corners_of(delaunay, c), c->info().marking.side, Side::unmarked, false, PointId()});
  }
  return cells;
}

void note_peel(const Delaunay& delaunay, std::vector<StagesCell>& cells) {
  std::size_t k = 0;
  for (const CellHandle c : delaunay.all_cell_handles()) {
    cells[k].peeled = c->info().marking.side;
    cells[k++].reached = c->info().reached;
  }
  std::sort(cells.begin(), cells.end(),
            [](const StagesCell& a, const StagesCell& b) { return a.corners < b.corners; });
}

}  // namespace

TightStages cgal_stages(Points points, const CgalCoconeOptions& options,
                        const TightStages* at_ties) {
  TightStages stages;
  Delaunay delaunay = triangulation_of(points);
  if (at_ties != nullptr) choose_at_ties(*at_ties, delaunay);
  const bool begun = find_candidates(delaunay, options);
  stages.normals = by_id(delaunay, &VertexInfo::normal);
  stages.heights = by_id(delaunay, &VertexInfo::height);
  stages.boundary = flags(delaunay, &VertexInfo::interior);
  for (std::uint8_t& flag : stages.boundary) flag ^= 1U;
  stages.candidates = surface_triangles(delaunay);
  prune(delaunay);
  stages.umbrella = flags(delaunay, &VertexInfo::umbrella);
  stages.left = surface_triangles(delaunay);
  walk(delaunay);
  stages.surface = surface_triangles(delaunay);
  mark(delaunay, options);
  stages.good = flags(delaunay, &VertexInfo::good);
  stages.visited = flags(delaunay, &VertexInfo::visited);
  stages.cells = marked_cells(delaunay);
  peel(delaunay);
  note_peel(delaunay, stages.cells);
  if (begun) stages.triangles = between(delaunay);
  stages.ties = ties_taken(delaunay);
  return stages;
}

}  // namespace cocoon::ref
