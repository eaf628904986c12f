// The 3D Delaunay triangulation as a value: points, cells, adjacency. Read-only for everybody but
// the kernel that builds it.
//
//   cell c = four vertices v0 v1 v2 v3 with orient3d > 0, and four neighbors; facet i lies
//   opposite vertex i. Convexity is completed by one vertex at infinity: each hull facet has an
//   infinite cell behind it, whose vertex 3 is `infinite_vertex`, and whose orientation is that of
//   a finite cell with a point beyond the hull facet in that place. So every facet has exactly two
//   cells, and no code needs a case for "no neighbor".
//
//   facet f = 4 * cell + i. neighbors[i] of a cell is a facet, not a cell: the same triangle seen
//   from the other side. So crossing a facet and coming back are one read each.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

inline constexpr VertexId infinite_vertex{std::uint32_t{0xFFFFFFFEU}};

// Aligned so that a record never lies across two cache lines.
struct alignas(32) Cell {
  std::array<VertexId, 4> vertices;
  std::array<FacetId, 4> neighbors;  // neighbors[i]: facet i as the cell behind it numbers it

  friend bool operator==(const Cell&, const Cell&) = default;
};
static_assert(sizeof(Cell) == 32);

template <>
struct ElementStorage<Cell> {
  using type = std::vector<Cell, OverwriteAllocator<Cell>>;
};

constexpr bool is_infinite(const Cell& cell) { return cell.vertices[3] == infinite_vertex; }

constexpr FacetId facet_id(CellId cell, int i) {
  return FacetId(4 * cell.value + static_cast<std::uint32_t>(i));
}
constexpr CellId cell_of(FacetId facet) { return CellId(facet.value >> 2); }
constexpr int index_of(FacetId facet) { return static_cast<int>(facet.value & 3U); }
// So cells have 30 bits; the last number stands for none.
inline constexpr std::size_t max_cells = (std::size_t{1} << 30) - 1;

// Vertices of facet i of a positively oriented cell, such that the normal
// (p1 - p0) x (p2 - p0) points out of the cell (away from vertex i).
inline constexpr int facet_corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
constexpr Triangle facet_vertices(const Cell& cell, int i) {
  const int* corner = facet_corners[i];
  return {cell.vertices[static_cast<std::size_t>(corner[0])],
          cell.vertices[static_cast<std::size_t>(corner[1])],
          cell.vertices[static_cast<std::size_t>(corner[2])]};
}

// What Triangulation and TriangulationView say of cells and facets alike.
inline VertexId vertex_of(const IdVector<CellId, Cell>& cells, CellId c, int i) {
  return cells[c].vertices[static_cast<std::size_t>(i)];
}
inline FacetId mirror_of(const IdVector<CellId, Cell>& cells, FacetId f) {
  return cells[cell_of(f)].neighbors[static_cast<std::size_t>(index_of(f))];
}
inline FacetId canonical_of(const IdVector<CellId, Cell>& cells, FacetId f) {
  const FacetId other = mirror_of(cells, f);
  return other < f ? other : f;
}

// What a triangulation is made of.
struct TriangulationArrays {
  IdVector<VertexId, Point> points;             // all different
  IdVector<CellId, Cell> cells;                 // finite cells first
  IdVector<PointId, VertexId> vertex_of_point;  // the vertex at each input point
};

class Triangulation {
 public:
  Triangulation() = default;

  // Takes over the arrays of a builder. Precondition (not tested here; check_delaunay reports it):
  // the layout above; the first `finite_cells` cells are finite, the rest infinite; each vertex is
  // that of some input point. Throws InputError if an input point names a vertex that is not there.
  // Complexity: O(input points), on the threads if no two of them are equal.
  Triangulation(TriangulationArrays arrays, std::size_t finite_cells,
                const Execution& execution = {});
  // Gives the arrays back, for code that rearranges them.
  TriangulationArrays release() && { return std::move(arrays_); }

  std::size_t num_vertices() const { return arrays_.points.size(); }
  std::size_t num_cells() const { return arrays_.cells.size(); }  // finite and infinite
  std::size_t num_finite_cells() const { return finite_cells_; }
  IdRange<VertexId> vertices() const { return arrays_.points.ids(); }
  IdRange<CellId> cells() const { return arrays_.cells.ids(); }
  IdRange<CellId> finite_cells() const { return id_range<CellId>(finite_cells_); }
  IdRange<CellId> infinite_cells() const {
    return {CellId(finite_cells_), CellId(arrays_.cells.size())};
  }

  const IdVector<VertexId, Point>& points() const { return arrays_.points; }
  const Point& point(VertexId v) const { return arrays_.points[v]; }
  const IdVector<CellId, Cell>& cell_records() const { return arrays_.cells; }
  const Cell& cell(CellId c) const { return arrays_.cells[c]; }
  bool is_infinite(CellId c) const { return c.index() >= finite_cells_; }
  VertexId vertex(CellId c, int i) const { return vertex_of(arrays_.cells, c, i); }

  // The same facet seen from the cell behind it. O(1).
  FacetId mirror(FacetId f) const { return mirror_of(arrays_.cells, f); }
  CellId neighbor(CellId c, int i) const { return cell_of(mirror(facet_id(c, i))); }
  // Of the two ids of a facet the smaller one: the one that stands for the facet in sets.
  FacetId canonical(FacetId f) const { return canonical_of(arrays_.cells, f); }
  // A facet is finite iff its three vertices are: at most one of its two cells is infinite.
  bool is_finite_facet(FacetId f) const { return !is_infinite(cell_of(f)) || index_of(f) == 3; }
  // The three vertices, ordered so that the normal points out of cell_of(f). For a facet of an
  // infinite cell only facet 3 is finite; its normal points into the hull.
  Triangle facet_vertices(FacetId f) const {
    return cocoon::facet_vertices(arrays_.cells[cell_of(f)], index_of(f));
  }
  // The vertex of cell_of(f) that is not on f.
  VertexId opposite_vertex(FacetId f) const { return vertex(cell_of(f), index_of(f)); }

  // The vertex of each input point (equal points share one), in the user's order.
  const IdVector<PointId, VertexId>& vertex_of_point() const { return arrays_.vertex_of_point; }
  // The first input point at each vertex. O(1).
  PointId point_of_vertex(VertexId v) const { return point_of_vertex_[v]; }
  std::size_t num_duplicates() const {
    return arrays_.vertex_of_point.size() - arrays_.points.size();
  }

 private:
  TriangulationArrays arrays_;
  std::size_t finite_cells_ = 0;
  IdVector<VertexId, PointId> point_of_vertex_;
};

}  // namespace cocoon
