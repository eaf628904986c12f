#include "delaunay/compact_delaunay.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cocoon {
namespace {

// Numbers without gaps, by slot: ascending, but for infinite cells, which come behind the finite
// ones.
struct Numbers {
  IdVector<VertexId, VertexId> vertex;
  IdVector<CellId, CellId> cell;
  std::size_t vertices = 0;
  std::size_t cells = 0;
  std::size_t finite_cells = 0;

  // Whether they are the slots: no gap, and infinite cells behind the finite ones.
  bool are_slots() const {
    return vertices == vertex.size() && cells == cell.size() &&
           (finite_cells == 0 || cell[CellId(finite_cells - 1)] == CellId(finite_cells - 1));
  }
};

Numbers number_elements(const DynamicDelaunay& delaunay) {
  const TriangulationView view = delaunay.view();
  Numbers numbers;
  numbers.vertex.resize(delaunay.num_vertex_slots());
  for (const VertexId v : numbers.vertex.ids()) {
    if (delaunay.contains(v)) numbers.vertex[v] = VertexId(numbers.vertices++);
  }
  numbers.cell.resize(view.cell_records().size());
  for (const CellId c : numbers.cell.ids()) {
    if (view.is_finite_cell(c)) numbers.cell[c] = CellId(numbers.cells++);
  }
  numbers.finite_cells = numbers.cells;
  for (const CellId c : numbers.cell.ids()) {
    if (!view.is_free(c) && view.is_infinite(c)) numbers.cell[c] = CellId(numbers.cells++);
  }
  return numbers;
}

// Both may be the same: no number is larger than its slot.
void move_points(const Numbers& numbers, const IdVector<VertexId, Point>& from,
                 IdVector<VertexId, Point>& to) {
  for (const VertexId v : numbers.vertex.ids()) {
    if (!numbers.vertex[v].is_none()) to[numbers.vertex[v]] = from[v];
  }
}

// Both may be the same: no number of a finite cell is larger than its slot, and the infinite ones
// wait.
void move_cells(const Numbers& numbers, const IdVector<CellId, Cell>& from,
                IdVector<CellId, Cell>& to) {
  std::vector<Cell> infinite;
  for (const CellId c : numbers.cell.ids()) {
    const CellId place = numbers.cell[c];
    if (place.is_none()) continue;
    Cell cell = from[c];
    for (VertexId& v : cell.vertices) v = v == infinite_vertex ? v : numbers.vertex[v];
    for (FacetId& f : cell.neighbors) f = facet_id(numbers.cell[cell_of(f)], index_of(f));
    if (place.index() < numbers.finite_cells) {
      to[place] = cell;
    } else {
      infinite.push_back(cell);
    }
  }
  std::copy(infinite.begin(), infinite.end(),
            to.begin() + static_cast<std::ptrdiff_t>(numbers.finite_cells));
}

CompactDelaunay compact(Numbers numbers, TriangulationArrays arrays,
                        const IdVector<PointId, VertexId>& vertex_of_point) {
  arrays.vertex_of_point.reserve(vertex_of_point.size());
  for (const VertexId v : vertex_of_point) {
    arrays.vertex_of_point.push_back(numbers.vertex[v]);
  }
  return {Triangulation(std::move(arrays), numbers.finite_cells), std::move(numbers.vertex),
          std::move(numbers.cell)};
}

}  // namespace

CompactDelaunay compact_delaunay(const DynamicDelaunay& delaunay,
                                 const IdVector<PointId, VertexId>& vertex_of_point) {
  const TriangulationView view = delaunay.view();
  Numbers numbers = number_elements(delaunay);
  TriangulationArrays arrays;
  arrays.points.resize(numbers.vertices);
  arrays.cells.resize(numbers.cells);
  move_points(numbers, view.points(), arrays.points);
  move_cells(numbers, view.cell_records(), arrays.cells);
  return compact(std::move(numbers), std::move(arrays), vertex_of_point);
}

CompactDelaunay compact_delaunay(DynamicDelaunay&& delaunay,
                                 const IdVector<PointId, VertexId>& vertex_of_point) {
  Numbers numbers = number_elements(delaunay);
  auto [points, cells] = std::move(delaunay).release();
  if (!numbers.are_slots()) {
    move_points(numbers, points, points);
    move_cells(numbers, cells, cells);
  }
  points.resize(numbers.vertices);
  cells.resize(numbers.cells);
  return compact(std::move(numbers), {std::move(points), std::move(cells), {}}, vertex_of_point);
}

}  // namespace cocoon
