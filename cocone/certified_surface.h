// The surface of a changing triangulation where it can only be one: known without walking, marking
// and peeling, and kept up to date where something changes.
//
// A certificate for a set S of facets with a chosen side (the outer one). At every vertex v:
//
//   1. v is an interior sample: it meets both conditions of boundary_samples.h, or meets the ratio
//      condition and is taken in at once by a neighbor that meets both.
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
// left to clean up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/local_patch.h"
#include "cocone/reconstruct.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

class CertifiedSurface {
 public:
  // `options` as the stages get them.
  explicit CertifiedSurface(const ReconstructOptions& options = {}) : options_(options) {}

  // Whether a surface is known.
  bool exists() const { return exists_; }
  // Forgets everything.
  void clear();

  // Looks for the certificate in the whole triangulation. Returns exists(). The same as update()
  // after a change of everything. Complexity: O(n).
  bool certify(const DynamicDelaunay& delaunay, const Execution& execution = {});

  // Goes on after a change of the triangulation; false (and nothing is known) if the certificate
  // does not hold any more. Precondition: exists() before the change.
  // Complexity: O(c) for c cells at the vertices at most two edges away from a new cell, and one
  // pass over a byte per cell if the first hull candidate went.
  bool update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
              const Execution& execution = {});

  // --- What is known. Precondition: exists().

  // n_p of a vertex.
  const Vec3& normal(VertexId v) const { return normals_[v]; }
  // The vertices at which the last operation may have changed the surface, and all triangles that
  // the surface has there now, counterclockwise seen from outside. All others are as before.
  const std::vector<VertexId>& touched() const { return touched_; }
  const std::vector<std::array<VertexId, 3>>& triangles_at_touched() const { return triangles_; }
  std::size_t finite_cells() const { return finite_cells_; }
  // What the stages would have counted.
  void count(ReconstructCounters& counters) const;

 private:
  struct Examination;
  bool examine(const DynamicDelaunay& delaunay, std::vector<VertexId> core,
               std::span<const VertexId> dirty, const Execution& execution);
  void forget(const DelaunayChange& change);
  void set_cell(CellId c, std::uint8_t flags, std::uint8_t outer, std::uint8_t pruned);
  void set_vertex(VertexId v, std::uint8_t flags);
  void commit(const DynamicDelaunay& delaunay, Examination& examination);
  bool first_hull_candidate_is_outer(const DynamicDelaunay& delaunay,
                                     const Examination& examination);
  bool is_connected(const DynamicDelaunay& delaunay, const Examination& examination) const;

  ReconstructOptions options_;
  bool exists_ = false;
  PatchBuilder patches_;
  // By vertex.
  IdVector<VertexId, Vec3> normals_;
  IdVector<VertexId, std::uint8_t> vertex_flags_;
  // By cell slot: bit i = facet i, seen from this cell, is the outer side of a facet of S ...
  IdVector<CellId, std::uint8_t> outer_;
  // ... and bit i = facet i is a candidate; above: how the center was obtained, and infinity.
  IdVector<CellId, std::uint8_t> cell_flags_;
  // ... and bit i = facet i is a candidate that was pruned.
  IdVector<CellId, std::uint8_t> pruned_;
  CellId first_hull_;  // the infinite cell at the first hull candidate

  std::size_t candidates_ = 0;  // from both sides
  std::size_t outer_halves_ = 0;
  std::size_t pruned_halves_ = 0;
  std::size_t num_vertices_ = 0;
  std::size_t hull_vertices_ = 0;
  std::size_t taken_in_ = 0;
  std::size_t exact_centers_ = 0;
  std::size_t facet_centers_ = 0;
  std::size_t finite_cells_ = 0;

  std::vector<VertexId> touched_;
  std::vector<std::array<VertexId, 3>> triangles_;
};

}  // namespace cocoon
