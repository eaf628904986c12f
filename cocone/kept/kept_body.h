// The body of a changing triangulation, and what a change does to its boundary: without a look at
// the boundary as a whole.
//
// A boundary is smooth if each vertex of the triangulation has one closed umbrella of its facets;
// here it is connected, too, which whoever edits its mesh relies on. Let it be smooth before a
// change. A cell is changed if it is new or has another side. A facet of the boundary after the
// change is old if one of its cells is not changed and had it as a facet of the boundary: then it
// was one with the same side inside. All others came.
//
//   1. A vertex is touched if a facet that came has it. At every other vertex all facets are old.
//      If there are any they are all that were there: each edge has an even number of them, and one
//      closed umbrella has no smaller part like that. So there the boundary is as it was.
//   2. It is smooth again if touched vertices have one closed umbrella, and all other corners of
//      changed cells have a facet of it.
//   3. A component of it without a touched vertex is the whole of the boundary before, with none of
//      its vertices touched. So it is connected if the triangles at touched vertices hang together
//      and one of them is old, or if nothing is touched.
//
// Source: ours, docs/stages/live_update.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cocone/kept/kept_labels.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/renumbering.h"
#include "delaunay/star_finder.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

class KeptBody {
 public:
  // Whether a body is kept.
  bool exists() const { return !cells_.empty(); }
  // Whether it is, and its boundary is known to be smooth and connected: by look_if_smooth(), or
  // since it was before the last change, too.
  bool is_smooth() const { return is_smooth_; }
  // Whether it may be, and was not looked at.
  bool may_be_smooth() const { return may_be_smooth_; }
  void clear() { *this = {}; }
  // Keeps the body of the cells that are not `out`, as one that is not known to be smooth.
  // Complexity: O(cells), parallel.
  void resume(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
              const Execution& execution = {});
  // 1 for the cells that are out, by slot. Precondition: no change since it was kept. Complexity:
  // O(cells).
  IdVector<CellId, std::uint8_t> out() const;

  struct Change {
    std::vector<VertexId> touched;
    // All triangles with one of these, counterclockwise seen from outside.
    std::vector<Triangle> triangles;
  };
  // Keeps the body of the cells that are not `out` (1, as infinite cells are). Where it was smooth
  // before and is now, what has changed is told; not of one that is said not to be. `cell_at`: a
  // cell at each vertex. Complexity: a byte of each cell, and the cells at the corners of changed
  // ones; a look at all cells if the triangles at touched vertices do not hang together; O(n) for
  // the first body, parallel.
  std::optional<Change> take(const Triangulation& triangulation,
                             const IdVector<VertexId, CellId>& cell_at,
                             const IdVector<CellId, std::uint8_t>& out, bool may_be_smooth,
                             const Execution& execution = {});

  // Looks whether the body last taken is smooth if it may be, and was not looked at before.
  // Precondition: no change since then. Complexity: O(n), parallel.
  void look_if_smooth(const Triangulation& triangulation, const Execution& execution = {});

  // After a change of the triangulation, and when gaps are closed. Complexity: O(change).
  void update(const DynamicDelaunay& delaunay, const DelaunayChange& change);
  void renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay);
  // The body as it was before the change, where it still is. Precondition: exists(). Complexity: a
  // byte of each cell.
  BodyBefore before(const Triangulation& triangulation) const;

 private:
  std::optional<Change> go_on(const Triangulation& triangulation,
                              const IdVector<VertexId, CellId>& cell_at,
                              const IdVector<CellId, std::uint8_t>& out,
                              std::span<const CellId> changed, const Execution& execution);
  std::vector<CellId> changed_cells(const IdVector<CellId, std::uint8_t>& out) const;
  bool is_old(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
              FacetId f) const;
  void renew(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
             std::span<const CellId> changed, const Execution& execution);
  void renew_all(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                 const Execution& execution);
  bool has_umbrellas(const Triangulation& triangulation, const Execution& execution) const;
  bool is_connected(const Triangulation& triangulation) const;

  // Of a cell: bits 0 to 3, the facets of the boundary; whether it is out, and whether it is new.
  IdVector<CellId, std::uint8_t> cells_;
  bool is_smooth_ = false;
  bool may_be_smooth_ = false;
  StarFinder stars_;
};

}  // namespace cocoon
