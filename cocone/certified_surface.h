// The surface of a changing triangulation where it can only be one: known without walking, marking
// and peeling, and kept up to date where something changes.
//
// A certificate for a set S of facets with a chosen side (the outer one). At every vertex v:
//
//   1. v is an interior sample (boundary_samples.h).
//   2. v has an umbrella of candidates (prune_sharp_edges.h).
//   3. S is one closed umbrella at v, and not folded: v is good (umbrella.h).
//   4. Whoever stands on the outer side of a facet of S at v and turns about one of its edges first
//      meets the next facet of S, from its outer side.
//
// And once for all: S is connected, and the lexicographically smallest candidate on the hull is in
// S, its outer side towards infinity.
//
// Then S is the result of all later stages. No sample is boundary, so candidates are the facets
// whose dual edge meets the cocones of all three corners. extract_manifold begins at that hull
// candidate and, by 4, walks over S alone, from the outer side, whatever the order of its rounds: a
// facet off S would have to be met first somewhere, and one of S can only be dropped at an edge
// with a third facet of S, against 3. S holds all vertices, so no second walk begins. A closed
// connected surface in the 3-sphere has two sides, so marking, from any vertex, finds one OUT and
// one IN; every vertex is good, so no cell is poor, the peel reaches what is OUT, and nothing is
// left to clean up. Source: ours, docs/stages/live_update.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/live_candidates.h"
#include "cocone/local_facets.h"
#include "cocone/star_finder.h"
#include "cocone/surface_state.h"
#include "cocone/umbrella.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/id_vector.h"

namespace cocoon {

class CertifiedSurface {
 public:
  explicit CertifiedSurface(const GoodVertexOptions& options = {}) : options_(options) {}

  // Whether a surface is known.
  bool exists() const { return exists_; }
  // Forgets everything.
  void clear();

  // Looks for the certificate in the whole triangulation, where the surface is known to have one
  // closed umbrella at every vertex, not folded, to be connected, and to hold the smallest hull
  // candidate: condition 4 is left to be seen. `halves`: its facets, seen from outside. Returns
  // exists(). Complexity: O(n).
  bool certify(const DynamicDelaunay& delaunay, const LiveCandidates& candidates,
               std::span<const FacetId> halves);

  // Begins with the sides() of another one whose triangulation and candidates were the same, in the
  // same slots. Complexity: O(n).
  void resume(const DynamicDelaunay& delaunay, IdVector<CellId, std::uint8_t> sides);

  // Goes on after a change of the triangulation and of the candidates; false (and nothing is known)
  // if the certificate does not hold any more. Precondition: exists() before the change.
  // Complexity: O(c) for c cells at the vertices at most one edge of the surface away from a
  // changed() one, and one pass over a byte per cell if the first hull candidate went, over the
  // triangles if the changed places do not hang together.
  bool update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
              const LiveCandidates& candidates);

  // --- What is known. Precondition: exists().

  // The vertices at which the last operation may have changed the surface, ascending, and all
  // triangles that the surface has there now, counterclockwise seen from outside. All others are as
  // before. After certify(): none.
  const std::vector<VertexId>& touched() const { return touched_; }
  const std::vector<std::array<VertexId, 3>>& triangles_at_touched() const { return triangles_; }
  // The whole surface by slot of the cell, as side_flag (surface_state.h) has it; 0 where no cell
  // is.
  const IdVector<CellId, std::uint8_t>& sides() const { return sides_; }
  // All its triangles, counterclockwise seen from outside. Complexity: O(cells).
  std::vector<std::array<VertexId, 3>> triangles(const TriangulationView& view) const;
  // What the stages would have counted.
  void count(ReconstructCounters& counters) const;

 private:
  bool is(unsigned side, FacetId f) const {
    return (sides_[cell_of(f)] & (side << index_of(f))) != 0;
  }
  void set_sides(CellId c, unsigned sides);
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
  bool holds_at(const LocalFacets& surface, std::span<const VertexId> vertices) const;
  void list_triangles(const TriangulationView& view, const LocalFacets& surface);
  bool holds_first_hull_candidate(const TriangulationView& view, const DelaunayChange& change,
                                  const LiveCandidates& candidates,
                                  std::span<const FacetId> touched);
  bool is_connected(const DynamicDelaunay& delaunay, const LocalFacets& surface) const;

  GoodVertexOptions options_;
  bool exists_ = false;
  FacetCollector collector_;
  StarFinder stars_;
  IdVector<CellId, std::uint8_t> sides_;
  CellId first_hull_;  // the infinite cell at the first hull candidate; none: to be looked for
  std::size_t outer_halves_ = 0;
  std::size_t num_vertices_ = 0;

  std::vector<VertexId> touched_;
  VertexSet is_touched_;  // during an update; else 0
  std::vector<std::array<VertexId, 3>> triangles_;
};

}  // namespace cocoon
