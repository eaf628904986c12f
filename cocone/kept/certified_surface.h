// The surface of a changing triangulation where it can only be one: known without walking, marking
// and peeling, and kept up to date where something changes.
//
// A certificate for a set S of facets with a chosen side (the outer one). At every vertex v of S:
//
//   1. v has an umbrella of candidates (prune_sharp_edges.h).
//   2. S is one closed umbrella at v. It may be folded, so that v is not good (umbrella.h).
//   3. Whoever stands on the outer side of a facet of S at v and turns about one of its edges first
//      meets the next facet of S, from its outer side.
//
// Besides:
//
//   4. A candidate off S has a corner on S: samples that S leaves out have no surface of their own.
//   5. Every finite cell has a good vertex.
//   6. The good vertices hang together by edges of S, and so does S.
//   7. Of the hull candidates whose corners have umbrellas the one with the smallest circle
//      (facet_size.h) is in S, its outer side towards infinity, with a good corner.
//
// Then S is the result of all later stages. extract_manifold begins at that hull candidate and, by
// 3, walks over S alone, from the outer side, whatever the order of its rounds: a facet off S would
// have to be met first somewhere, and one of S can only be dropped at an edge with a third facet of
// S, against 2. By 4 no second walk begins, and nothing else is kept. A closed connected surface in
// the 3-sphere has two sides. So marking, which by 6 and 7 comes to all good vertices, finds one
// OUT and one IN, without conflict; by 5 each cell is told its side, none is poor, and the peel
// reaches just what is OUT. The clean-up has no undecided cell, and S is pinched nowhere: then it
// does nothing. Samples off S are not missed, since all their cells are decided.
// Source: ours, docs/stages/live_update.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/live/live_candidates.h"
#include "cocone/live/local_facets.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/live/surface_state.h"
#include "cocone/reconstruct.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/star_finder.h"
#include "geom/id_vector.h"

namespace cocoon {

class CertifiedSurface {
 public:
  // `options` as the stages get them.
  explicit CertifiedSurface(const ReconstructOptions& options = {}) : options_(options) {}

  // Whether a surface is known.
  bool exists() const { return exists_; }
  // Forgets everything, but for the place that certify() asks first.
  void clear();

  // Looks for the certificate in the whole triangulation, for a surface that the stages found in
  // one walk, with no poor cell, no good vertex unvisited, and no rounds of marks. Returns
  // exists(). An edge at which 3 did not hold, or a corner at which 1 did not, is asked first the
  // next time: if it still does not, nothing else needs to be asked.
  // Complexity: O(n), and the stars of vertices off the surface.
  bool certify(const DynamicDelaunay& delaunay, const LiveCandidates& candidates,
               const CoconeSurface& surface);

  // Begins with the sides() and sheets() of another one whose triangulation and candidates were the
  // same, in the same slots. Complexity: O(n).
  void resume(const DynamicDelaunay& delaunay, IdVector<CellId, std::uint8_t> sides,
              IdVector<VertexId, SheetAt> sheets);

  // Goes on after a change of the triangulation and of the candidates; false (and nothing is known)
  // if the certificate does not hold any more. Precondition: exists() before the change.
  // Complexity: O(c) for c cells at the vertices at most one edge of the surface away from a
  // changed() one, and one pass over a byte per cell if the first hull candidate went, over the
  // triangles if the changed places do not hang together, or hold no vertex that was good before.
  bool update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
              const LiveCandidates& candidates);

  // --- What is known. Precondition: exists().

  // The vertices at which the last operation may have changed the surface, ascending, and all
  // triangles that the surface has there now, counterclockwise seen from outside. All others are as
  // before. After certify(): none.
  const std::vector<VertexId>& touched() const { return touched_; }
  const std::vector<Triangle>& triangles_at_touched() const { return triangles_; }
  // The whole surface by slot of the cell, as side_flag (surface_state.h) has it; 0 where no cell
  // is.
  const IdVector<CellId, std::uint8_t>& sides() const { return sides_; }
  // What it is at each vertex, by slot; none where no vertex is.
  const IdVector<VertexId, SheetAt>& sheets() const { return sheets_; }
  bool has(VertexId v) const { return sheets_[v] != SheetAt::none; }
  std::size_t num_vertices() const { return good_ + folded_; }
  // All its triangles, counterclockwise seen from outside. Complexity: O(cells).
  std::vector<Triangle> triangles(const TriangulationView& view) const;
  // What the stages would have counted.
  void count(ReconstructCounters& counters) const;

 private:
  bool is(unsigned side, FacetId f) const {
    return (sides_[cell_of(f)] & (side << index_of(f))) != 0;
  }
  bool is_good(VertexId v) const { return sheets_[v] == SheetAt::good; }
  struct Turn {
    FacetId from;    // a half of the surface, none: no turn
    VertexId third;  // its corner that is not on the edge
  };
  bool is_still_refuted(const TriangulationView& view, const LiveCandidates& candidates,
                        std::span<const FacetId> halves) const;
  void begin_sheets(const DynamicDelaunay& delaunay, const CoconeSurface& surface);
  Turn find_open_turn(const TriangulationView& view, const LiveCandidates& candidates,
                      std::span<const FacetId> halves) const;
  Turn find_wrong_turn(const TriangulationView& view, const LiveCandidates& candidates,
                       std::span<const FacetId> halves) const;
  void count_sheets();
  void set_sides(CellId c, unsigned sides);
  void set_sheet(VertexId v, SheetAt sheet);
  void insert(const TriangulationView& view, FacetId half);
  void erase(const TriangulationView& view, FacetId f);
  bool has_touched_vertex(const TriangulationView& view, FacetId f) const;

  void forget(const DelaunayChange& change);
  void adopt_new_cells(const TriangulationView& view, const DelaunayChange& change);
  bool update_at_touched(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                         const LiveCandidates& candidates);
  void erase_touched(const TriangulationView& view, const LiveCandidates& candidates,
                     std::span<const FacetId> touched);
  std::vector<VertexId> find_ring(const TriangulationView& view, const LiveCandidates& candidates,
                                  std::span<const FacetId> touched) const;
  std::vector<FacetId> halves_at(const DynamicDelaunay& delaunay, std::span<const VertexId> at);
  bool grow(const TriangulationView& view, const LiveCandidates& candidates,
            std::vector<FacetId> open);
  bool find_sheets(const LiveCandidates& candidates, const LocalFacets& surface,
                   std::span<const VertexId> vertices);
  bool decides_cells(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                     std::span<const VertexId> vertices);
  bool leaves_no_candidate(const DynamicDelaunay& delaunay, const LiveCandidates& candidates,
                           std::span<const VertexId> vertices);
  void list_triangles(const TriangulationView& view, const LocalFacets& surface);
  bool holds_first_hull_candidate(const TriangulationView& view, const DelaunayChange& change,
                                  const LiveCandidates& candidates,
                                  std::span<const FacetId> touched);
  bool is_connected(const TriangulationView& view, const LocalFacets& surface) const;

  ReconstructOptions options_;
  bool exists_ = false;
  FacetCollector collector_;
  StarFinder stars_;
  IdVector<CellId, std::uint8_t> sides_;
  IdVector<VertexId, SheetAt> sheets_;
  CellId first_hull_;  // the infinite cell at the first hull candidate; none: to be looked for
  std::size_t outer_halves_ = 0;
  std::size_t good_ = 0;
  std::size_t folded_ = 0;
  std::size_t off_surface_ = 0;  // vertices of the triangulation
  std::size_t new_good_ = 0;     // during an update: vertices that are good now, and were not
  Turn wrong_turn_;              // of a surface without a certificate

  std::vector<VertexId> touched_;
  VertexSet is_touched_;  // during an update; else 0
  std::vector<Triangle> triangles_;
};

}  // namespace cocoon
