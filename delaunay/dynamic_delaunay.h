// A Delaunay triangulation that changes: points come and go, and what stays is left alone.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/kernel/removal.h"
#include "delaunay/renumbering.h"
#include "delaunay/triangulation.h"
#include "delaunay/triangulation_view.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// What one operation changed. Ids are slots, which are used again: a slot whose cell was replaced
// is among both the deleted and the created cells. A cell that keeps its vertices also keeps its
// slot, though its neighbors may be new; so whatever depends on a cell, or on the two cells at a
// facet, is to be computed again only at `created` cells.
struct DelaunayChange {
  std::vector<CellId> created;            // live now, and not in this form before
  std::vector<CellId> deleted;            // live before, and no longer in this form
  std::vector<VertexId> inserted;         // new vertices
  std::vector<VertexId> removed;          // vertices that are gone
  std::vector<VertexId> vertex_of_point;  // the vertex at each point to be inserted
  std::size_t duplicates = 0;             // points that were already there, or came twice
  DelaunayCounters insertion;
  RemovalCounters removal;
};

// A DynamicDelaunay as a value for the stages.
struct FrozenDelaunay {
  // Vertices numbered along the Hilbert curve, as delaunay() numbers them, and in canonical_order
  // equal to its result, whatever the history. The input points of vertex_of_point() are the
  // vertices of the DynamicDelaunay, in increasing order of their ids.
  Triangulation triangulation;
  IdVector<VertexId, VertexId> frozen_vertex;  // by id before; none for ids not in use
};

// The Delaunay triangulation of a set of points, under the perturbation of geom/perturbation.h.
//
//   - It is a set: a point equal to a vertex is that vertex, however often it was inserted, and
//     removing the vertex removes the point. Whoever counts copies counts them outside.
//   - It is empty, or its vertices span space. An operation that would leave something between
//     throws InputError.
//   - Vertices keep their ids as long as they live. Ids of removed vertices are used again.
//   - After any operations the cells are those of delaunay() for the points that are there; only
//     their numbering shows the history. freeze() shows none.
//
// Operations throw InputError for a point that is not finite, an id that is no vertex, and what is
// above; Cancelled if progress is cancelled. Then the point set and the vertex ids are as before,
// though cells may have other numbers (not so if memory runs out).
// Complexity: each operation costs O(n^(1/4) + k log k) expected for a change of k vertices and
// cells, apart from the growth of arrays: the first new point is searched for from a sample of the
// n vertices, each other one from the point before. Deterministic: same history, same numbers; so
// for every execution.threads, but where all vertices are replaced: then the cells are numbered as
// delaunay() numbers them.
class DynamicDelaunay {
 public:
  DynamicDelaunay();
  // Takes over a Delaunay triangulation; its vertices keep their ids. Complexity: O(cells).
  explicit DynamicDelaunay(Triangulation triangulation);
  ~DynamicDelaunay();
  DynamicDelaunay(DynamicDelaunay&&) noexcept;
  DynamicDelaunay& operator=(DynamicDelaunay&&) noexcept;

  // Precondition: `points` are not those of its own view().
  DelaunayChange insert(Points points, const Execution& execution = {});
  // Ids may be repeated. Removing all vertices leaves an empty triangulation.
  DelaunayChange remove(std::span<const VertexId> vertices, const Execution& execution = {});
  // Both at once: only the final set must span space. A point equal to a vertex to be removed is
  // kept or made a new vertex.
  DelaunayChange replace(std::span<const VertexId> vertices, Points points,
                         const Execution& execution = {});

  std::size_t num_vertices() const;
  // Vertex ids are below this number.
  std::size_t num_vertex_slots() const;
  bool contains(VertexId v) const;
  // Precondition for both: contains(v).
  const Point& point(VertexId v) const;
  CellId cell_at(VertexId v) const;  // one of the cells at v
  // The same by slot; none where no vertex is. Valid until the next operation.
  const IdVector<VertexId, CellId>& cells_at_vertices() const;
  // Valid until the next operation. Its points have elements that are no vertices.
  TriangulationView view() const;

  // Complexity: O(n).
  FrozenDelaunay freeze() const;

  // Numbers vertices and cells without gaps, finite cells first. Complexity: a look at each cell,
  // and O(star) for each vertex that moves.
  Renumbering close_gaps();
  // The triangulation for the stages in the ids that it has here, without a copy; `vertex_of_point`
  // as in Triangulation. Until it is given back nothing but cells_at_vertices() may be called.
  // Precondition: no operation, not even one that threw, since a triangulation was taken over or
  // close_gaps() called. Complexity: O(input points).
  Triangulation lend(IdVector<PointId, VertexId> vertex_of_point);
  // Returns vertex_of_point. Complexity: O(1).
  IdVector<PointId, VertexId> take_back(Triangulation triangulation);

  // Gives up what view() shows, with its gaps. Complexity: O(1).
  struct Elements {
    IdVector<VertexId, Point> points;
    IdVector<CellId, Cell> cells;
  };
  Elements release() &&;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cocoon
