// Removing vertices from a Delaunay triangulation, many at once.
//
// The cells at the removed vertices form holes: two of them are in one hole iff they are connected
// through facets that lose a vertex. All other facets, simplices with empty spheres whose vertices
// stay, stay themselves; so each hole has a border of facets that are final, and what fills it
// follows from the vertices on this border alone (delaunay/kernel/hole_filler.h).
//
//        r removed                hole, border             filled
//      a-------b                 a-------b                a-------b
//      |\     /|                 |       |                |\      |
//      |  \ /  |                 |       |                |  \    |
//      |   r   |       ->        |       |       ->       |    \  |
//      |  / \  |                 |       |                |      \|
//      d-------c                 d-------c                d-------c
//
// Source: Devillers & Teillaud, Perturbations and vertex removal in a 3D Delaunay triangulation
// (SODA 2003), for the perturbation that makes the filling unique; here for any number of vertices
// at once, and for the hull without a case of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/kernel/cell_pool.h"
#include "delaunay/kernel/hole_filler.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// What removals did.
struct RemovalCounters {
  std::size_t holes = 0;
  std::size_t largest_hole = 0;     // cells deleted in one hole
  std::size_t border_vertices = 0;  // summed over the holes
  std::size_t flat_borders = 0;     // holes whose border vertices do not span space: filled with
                                    // infinite cells only, found with vertices from elsewhere
  std::size_t cells_deleted = 0;
  std::size_t cells_created = 0;
  DelaunayCounters filling;  // of the triangulations of the borders

  RemovalCounters& operator+=(const RemovalCounters& other);
};

// Holds the scratch memory that removals share.
class VertexRemover {
 public:
  // Both must outlive the remover; `points` ends with an element that is no vertex.
  VertexRemover(CellPool& pool, const IdVector<VertexId, Point>& points);

  // Works out what removing `vertices` does; writes nothing to the triangulation. Returns false if
  // the remaining vertices do not span space: then there is no triangulation without them.
  // `cell_at`: a cell at each vertex. Preconditions: the vertices are in the triangulation, all
  // different, and not all there are.
  // Complexity: that of a triangulation of the vertices around each hole.
  bool plan(std::span<const VertexId> vertices, const IdVector<VertexId, CellId>& cell_at);

  // Does what was planned. Between the two calls nothing else may change the triangulation.
  // Errors: InputError if the cells exceed their 30-bit numbering; then nothing has changed.
  // Complexity: O(cells deleted and created).
  void commit();

  // Of the last plan, once committed. New cells took slots of deleted ones first.
  std::span<const CellId> deleted_cells() const { return hole_cells_; }
  std::span<const CellId> new_cells() const { return slots_; }
  const RemovalCounters& counters() const { return counters_; }

 private:
  // A facet of a hole's border: old cells on both sides.
  struct BorderFacet {
    FacetId inner;         // as the deleted cell numbers it
    FacetId outer;         // as the cell behind it numbers it
    bool is_seam = false;  // the cell behind it is deleted, too: both sides are filled anew
    FacetId filled{};      // the facet of fill_cells_ that it becomes
  };
  struct Hole {
    std::size_t first_cell = 0;  // in hole_cells_
    std::size_t end_cell = 0;
    std::size_t first_border = 0;  // in border_
    std::size_t end_border = 0;
    std::size_t first_vertex = 0;  // in hole_vertices_
    std::size_t end_vertex = 0;
  };
  // Of a vertex, while holes are collected.
  enum class Fate : std::uint8_t { stays, is_removed, stays_and_is_listed };

  bool loses(VertexId v);
  void collect_holes(std::span<const VertexId> vertices, const IdVector<VertexId, CellId>& cell_at);
  void collect_hole(CellId start);
  bool find_anchor();
  void link_vertex(VertexId v);
  void link_border_vertices(const Hole& hole);
  void forget_link();
  void fill_hole(const Hole& hole);
  FacetId placed(FacetId filled) const;
  void join_seams();

  CellPool& pool_;
  const IdVector<VertexId, Point>& points_;
  HoleFiller filler_;
  RemovalCounters counters_;

  // The plan.
  std::vector<Hole> holes_;
  std::vector<CellId> hole_cells_;
  std::vector<VertexId> hole_vertices_;  // those that stay, of the holes one after the other
  std::vector<BorderFacet> border_;
  std::vector<Cell> fill_cells_;      // neighbors: facets of fill_cells_, none on a border
  std::vector<CellId> slots_;         // by cell of fill_cells_: its place in the pool
  std::array<VertexId, 4> anchor_{};  // remaining vertices that span space

  // Scratch arrays as long as the triangulation, all zero or none between calls.
  IdVector<VertexId, Fate> fate_;
  IdVector<CellId, std::uint8_t> in_hole_;
  IdVector<VertexId, VertexId> number_of_;  // of a vertex in link_

  std::vector<VertexId> link_;  // the vertices given to filler_, in its numbering
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> order_;
};

}  // namespace cocoon
