// Which cells must go when a point comes? The walk to a first one, and the search for all.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/kernel/cell_pool.h"
#include "delaunay/kernel/filter_bounds.h"
#include "delaunay/kernel/vertex_claims.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

struct SearchView;

// Where a search enters what it finds.
struct ZoneLists {
  CellId* cells;       // in conflict, in breadth-first order
  VertexId* vertices;  // the corners of the first cell, then the apex of each other
  FacetId* border;
  std::size_t capacity;  // of `cells`; `border` has room for all their facets
};

// The cells in conflict with a point, and their border: each of its facets as the cell outside
// numbers it.
class ConflictZone {
 public:
  std::span<const CellId> cells() const { return {cells_.data(), num_cells_}; }
  std::span<const FacetId> border() const { return {border_.data(), num_border_}; }
  // All vertices of the cells, some more than once.
  std::span<const VertexId> vertices() const { return {vertices_.data(), num_cells_ + 3}; }

  // Is there an infinite cell among them or behind the border? If not, the border is finite.
  bool has_infinite() const { return has_infinite_; }

  // For the search. Memory is kept from one to the next.
  ZoneLists start_lists();
  ZoneLists grow();  // keeps what was entered
  void finish(std::size_t num_cells, std::size_t num_border, bool has_infinite) {
    num_cells_ = num_cells;
    num_border_ = num_border;
    has_infinite_ = has_infinite;
  }

 private:
  std::size_t capacity_ = 64;
  std::vector<CellId> cells_;
  std::vector<VertexId> vertices_;
  std::vector<FacetId> border_;
  std::size_t num_cells_ = 0;
  std::size_t num_border_ = 0;
  bool has_infinite_ = false;
};

// The searches in one triangulation, and what their tests have in common. Of the pool only marks
// are written: those of cells in conflict and of cells behind their facets.
class ConflictSearch {
 public:
  // `points` must outlive the search and end with one element that is no vertex: the last vertex
  // is read as four doubles. Complexity: O(n).
  ConflictSearch(CellPool& pool, const IdVector<VertexId, Point>& points,
                 const Execution& execution = {});

  // For one of several threads, each with a copy: `holder`, which must outlive this, takes the
  // vertices of all cells that a walk enters and of all cells in conflict.
  void search_beside_others(ClaimHolder& holder) { holder_ = &holder; }

  // To be called when `points` was filled with other points. Complexity: O(n).
  void read_points_again(const Execution& execution = {});

  // To be called for a point that was not in `points` at construction, before it becomes a vertex.
  // Complexity: O(1).
  void admit(const Point& p);

  // A cell in conflict with p, if p is no vertex; a cell with a corner there, if it is. Visibility
  // walk from `hint` (delaunay/locate.h), all four facets of a cell in SIMD lanes; it ends at the
  // first cell whose circumsphere certainly contains p, which costs one more dot product: expanded
  // by the squared distances of the corners, the determinant of insphere has those of the four
  // facets as cofactors. Beside others: all vertices of `hint` must be held; none if another thread
  // is in the way, otherwise all vertices of the result are held. Complexity: as locate.
  CellId find_start(const Point& p, CellId hint, DelaunayCounters& counters);

  // Finds all cells in conflict with p, where `start` is one: a set connected by facets. They are
  // marked; who fills the hole takes the marks away. Around each cell found the four cells behind
  // its facets are tested at once in SIMD lanes, by the determinant of insphere (geom/insphere.h),
  // in doubles and where these cannot tell in pairs of them (delaunay/kernel/filter_bounds.h);
  // exact predicates decide the rest. The instruction set is chosen at run time; the result, order
  // included, is the same on all. Beside others: false if another thread is in the way; then
  // nothing is marked. Complexity: O(size of the zone).
  bool find_zone(const Point& p, CellId start, DelaunayCounters& counters);

  // Takes the marks of the zone away. Complexity: O(size of the zone).
  void unmark_zone();

  // What the last find_zone found.
  const ConflictZone& zone() const { return zone_; }

 private:
  SearchView view(const Point& p, DelaunayCounters& counters);

  CellPool& pool_;
  const IdVector<VertexId, Point>& points_;
  ConflictZone zone_;
  ClaimHolder* holder_ = nullptr;  // not owned; null: there is one thread
  double unit_ = 0;                // all coordinates are multiples of it; 0: nothing is known
  ExactReaches reaches_;
};

}  // namespace cocoon
