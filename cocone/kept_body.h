// The body of a changing triangulation, and what a change does to its boundary: without a look at
// the boundary as a whole.
//
// A boundary is smooth if each vertex of the triangulation has one closed umbrella of its facets;
// it is connected, too, which whoever edits its mesh relies on. Let it be smooth before and after a
// change, and let a cell be changed if it is new or on the other side. A vertex is touched if a
// facet of the boundary after the change has it and a changed cell. At every other vertex both
// cells of each facet after the change are as they were and on their sides; they shared the facet
// before, so it was one of the boundary. One closed umbrella is no proper part of another one, so
// they are all: the boundary is as it was there. A new vertex has new cells alone; a point that
// came and is an old vertex is none. Source: ours, docs/stages/live_update.md.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cocone/mark_cells.h"
#include "cocone/star_finder.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/renumbering.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

class KeptBody {
 public:
  // Whether a body is kept.
  bool exists() const { return !out_.empty(); }
  void clear() { out_ = {}; }

  // Keeps the body of these marks if its boundary is seen to be connected: each vertex that is not
  // good has a facet of it with one that is; and if there are few of these (4096 at most).
  // `cell_at`: a cell at each vertex. Precondition: each vertex has one closed umbrella of the
  // boundary, and the good ones hang together by edges of it. Complexity: a byte of each cell, and
  // the stars of vertices that are not good.
  void keep(const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at,
            const CellMarks& marks);
  // After a change of the triangulation, and when gaps are closed. Complexity: O(change).
  void update(const DynamicDelaunay& delaunay, const DelaunayChange& change);
  void renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay);

  struct Change {
    std::vector<VertexId> touched;
    // All triangles with one of these, counterclockwise seen from outside.
    std::vector<std::array<VertexId, 3>> triangles;
  };
  // From the kept body to another one with a smooth boundary; `out`: 1 = a cell is not of it.
  // Precondition: exists(). Complexity: a byte of each cell, and the cells around changed ones.
  Change change_to(const Triangulation& triangulation,
                   const IdVector<CellId, std::uint8_t>& out) const;

 private:
  IdVector<CellId, std::uint8_t> out_;  // 1: not of the body; or that the cell is new
  StarFinder stars_;
};

}  // namespace cocoon
