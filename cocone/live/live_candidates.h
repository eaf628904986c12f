// The stages from the poles to pruning for a set of points that changes: what they say of it, kept
// up to date where it may differ.
//
// After a change of the triangulation a vertex of a new cell is `dirty`. What is looked at again:
//
//   normals, ratio condition   dirty vertices: stars of others are as before, bit for bit
//   normal condition           these, and their cocone neighbors: who met it fails it if a dirty
//                              neighbor disagrees; who failed it is judged anew
//   phase 2                    samples that fail only the normal condition, where a supporter has
//                              changed. Each knows the number of steps after which it was taken in:
//                              a supporter with fewer steps proves that it belongs, so nobody is
//                              held by a circle. Who loses the proof is looked at again, and so on
//   candidates                 facets with a dirty corner, or one that changed its label
//   umbrellas                  corners of facets that became candidates or ceased to be
//   pruning                    edges at these; a triangle at the rim of the part that ends in
//                              another way than before makes the part grow, until all agree
//
// Each is computed by the stage itself, on a part of the triangulation (local_patch.h) or of the
// candidates (local_facets.h). Source: ours, docs/stages/live_update.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/live/candidate_counts.h"
#include "cocone/live/local_facets.h"
#include "cocone/live/local_patch.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/live/surface_state.h"
#include "cocone/reconstruct.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

class LiveCandidates {
 public:
  // `options` as the stages get them.
  explicit LiveCandidates(const ReconstructOptions& options = {}) : options_(options) {}

  // Whether anything is known.
  bool exists() const { return exists_; }
  void clear();
  // Begins with what the stages found in the triangulation that `delaunay` was made of. Their
  // triangulation is not read, it may have gone. Complexity: O(n).
  void start(const DynamicDelaunay& delaunay, const ReconstructStages& stages);
  // Begins with the state() of another one, whose triangulation had the same cells and vertices in
  // the same slots. Complexity: O(n).
  void resume(const DynamicDelaunay& delaunay, CandidateState state);
  // Goes on after a change of the triangulation. Precondition: exists() before the change.
  // Complexity: O(c) for c cells at vertices of new cells, as a rule.
  void update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
              const Execution& execution = {});

  // Follows when gaps of the triangulation are closed. changed() and what goes with it are empty
  // then. Complexity: O(moves).
  void renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay);

  // --- What is known. Precondition: exists().

  // The vertices that are new, changed their label or umbrella, or have another set of candidates
  // left after the last operation; ascending. At all others these things are as before.
  const std::vector<VertexId>& changed() const { return changed_; }
  // Among others all candidates at changed vertices, pruned ones included.
  const LocalFacets& facets_at_changed() const { return facets_; }
  // Facets, not gone, that were candidates before the last operation and no longer are.
  const std::vector<FacetId>& dropped() const { return dropped_; }
  const Vec3& normal(VertexId v) const { return known_.normals[v]; }
  bool is_boundary(VertexId v) const { return known_.steps[v] == not_taken_in; }
  bool has_umbrella(VertexId v) const {
    return (known_.vertex_flags[v] & vertex_flag::umbrella) != 0;
  }
  // Bit i: facet i of the cell is a candidate that was not pruned.
  unsigned left(CellId c) const { return known_.left(c); }
  bool is_infinite(CellId c) const { return (known_.cell_flags[c] & cell_flag::infinite) != 0; }
  std::size_t num_vertices() const { return num_vertices_; }
  std::size_t num_boundary() const { return counts_.boundary; }
  std::size_t num_finite_cells() const { return counts_.finite_cells; }
  // All of it, by slot; slots not in use have no meaning.
  const CandidateState& state() const { return known_; }
  // What the stages would have counted.
  void count(ReconstructCounters& counters) const { counts_.report(counters); }

 private:
  // The samples at which something may differ, with their stars.
  struct Part {
    LocalPatch patch;
    Dual dual;
    Poles poles;
    Cocones cocones;
    IdVector<VertexId, SampleState> states;
    IdVector<VertexId, std::uint32_t> steps;
    VertexSet fresh;  // dirty, or with another label

    bool has(const VertexSet& set, FacetId f) const;
  };

  void start_samples(const TriangulationView& view, const ReconstructStages& stages);
  void begin(const DynamicDelaunay& delaunay);
  void fit_arrays(const DynamicDelaunay& delaunay);
  void forget(const DelaunayChange& change);
  void examine(const DynamicDelaunay& delaunay, const Execution& execution);
  Part judge_part(const DynamicDelaunay& delaunay, const Execution& execution);
  std::vector<VertexId> pending_off_core(const LocalPatch& patch) const;
  void find_normals(Part& part, const Execution& execution) const;
  std::vector<VertexId> judge(Part& part, const Execution& execution) const;
  std::vector<VertexId> take_in(Part& part) const;
  void commit_samples(Part& part);
  void commit_new_cells(const Part& part);
  void update_candidates(const Part& part, const Execution& execution);
  void collect_facets(const DynamicDelaunay& delaunay, std::span<const VertexId> vertices);
  void update_umbrellas();
  void update_pruning(const DynamicDelaunay& delaunay);
  std::uint8_t was_pruned(FacetId f) const;
  void commit_pruning(const std::vector<std::uint8_t>& removed);
  void note_changed(VertexId v) { changed_.push_back(v); }
  void sort_changed();
  void set_cell(CellId c, unsigned flags, unsigned pruned);
  void set_vertex(VertexId v, unsigned flags, SampleState state, std::uint32_t steps);

  ReconstructOptions options_;
  bool exists_ = false;
  PatchBuilder patches_;
  FacetCollector collector_;
  CandidateState known_;
  IdVector<VertexId, std::uint32_t> fan_;  // candidates at the vertex, by slot

  std::vector<VertexId> dirty_;
  VertexSet is_dirty_;  // scratch
  std::vector<VertexId> changed_;
  LocalFacets facets_;
  std::vector<FacetId> dropped_;

  std::size_t num_vertices_ = 0;
  CandidateCounts counts_;
};

}  // namespace cocoon
