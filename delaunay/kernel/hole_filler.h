// Filling a hole of a Delaunay triangulation from the vertices around it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/kernel/cavity.h"
#include "delaunay/kernel/cell_pool.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Vertices of a hole are numbered in the order in which they were added, its cells by their
// position in `cells`.
struct HoleFilling {
  std::vector<Cell> cells;               // neighbors[i] is none where facet i is on the border
  std::vector<FacetId> facet_at_border;  // by border triangle: the facet of `cells` that it is
};

// Triangulates the vertices around one hole after the other; keeps its memory from hole to hole.
//
// Why this is exact: let S be the points that remain, H a hole of their triangulation, L the
// vertices around H or more points of S. A cell of Delaunay(S) inside H has all vertices on the
// border of H, hence in L, and its sphere is empty of S, hence of L: it is a cell of Delaunay(L).
// The perturbation is a function of coordinates alone, so that ties are broken in the same way.
// Infinite cells are cells like others: they have empty half-spaces in place of spheres.
// Source: Devillers & Teillaud 2003 (the perturbation that makes the filling unique); holes of many
// vertices at once are ours, docs/stages/dynamic_delaunay.md.
class HoleFiller {
 public:
  HoleFiller() : inserter_(pool_, points_) {}
  HoleFiller(const HoleFiller&) = delete;  // inserter_ refers to pool_ and points_
  HoleFiller& operator=(const HoleFiller&) = delete;

  // Forgets the last hole.
  void clear();
  // All points of a hole must be different. Returns its number.
  VertexId add_point(const Point& p) { return points_.push_back(p); }
  // Complexity: O(1) if the first points are in general position.
  bool spans_space();

  // The cells inside the hole whose border consists of the given triangles, each with the vertices
  // of a facet as the cell inside the hole orients it (facet_corners). Preconditions: the last
  // call was spans_space(), and it was true; the border consists of facets of the triangulation
  // of the points, and what is inside is connected through other facets. No border: all cells.
  // Complexity: that of a triangulation of the points.
  const HoleFilling& fill(std::span<const Triangle> border, DelaunayCounters& counters);

 private:
  void triangulate(DelaunayCounters& counters);
  void index_border(std::span<const Triangle> border);
  std::uint32_t find_border(const Triangle& triangle) const;
  CellId first_cell_inside() const;
  std::uint32_t enter(CellId c);

  IdVector<VertexId, Point> points_;  // while triangulated, with one element behind the last
  CellPool pool_;
  CavityInserter inserter_;
  std::vector<std::uint32_t> order_;
  std::vector<Triangle> border_;                // each with its smallest vertex first
  std::vector<std::uint32_t> border_table_;     // open addressing; positions in border_
  IdVector<CellId, std::uint32_t> fill_index_;  // by cell of pool_
  std::vector<CellId> inside_;                  // by cell of filling_: the cell of pool_
  HoleFilling filling_;
};

}  // namespace cocoon
