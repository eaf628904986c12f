// The steps of one reconstruction, which the compositions take from the first to the last.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/cell_marks.h"
#include "cocone/close_body.h"
#include "cocone/extract_manifold.h"
#include "cocone/facet_set.h"
#include "cocone/known_labels.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/poles.h"
#include "cocone/reconstruct.h"
#include "cocone/samples/cone_sides.h"
#include "cocone/surface_mesh.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// First a triangulation: triangulate(), take() or refer_to(). Then tight_result(); or find_poles(),
// build_surface(), deliver_open_surface() and verify(false); or extract_from(), close_surface() and
// verify(true). At last take_result(), unless a step has returned it.
// Errors and complexity: those of the compositions (reconstruct.h, reconstruct_stages.h).
class ReconstructSteps {
 public:
  // The points must outlive the object.
  ReconstructSteps(Points points, const ReconstructOptions& options, const Execution& execution);
  ReconstructSteps(const ReconstructSteps&) = delete;
  ReconstructSteps& operator=(const ReconstructSteps&) = delete;

  // From now on `live` marks cells and is asked to take the body, and take_surface() has triangles.
  // It must outlive the object.
  void use(const LiveStages& live) { live_ = &live; }
  // From now on what is found is kept for `stages`, which take_result() fills in.
  void keep_stages(ReconstructStages& stages) { stages_ = &stages; }

  void triangulate();
  // `triangulation` is that of the points times their working scale.
  void take(Triangulation triangulation);
  // The same without taking it over.
  void refer_to(const Triangulation& triangulation);

  void find_poles();

  // The Cocone surface with its boundary samples.
  void build_surface();

  // What find_poles() and build_surface() do, but for what is known.
  void extract_from(KnownCandidates candidates);

  // With a second look (second_look.h), if there is to be one. If what it finds is taken,
  // take_surface() and the stages get what the first one has found.
  void close_surface(const KnownLabelsSource& known);

  void deliver_open_surface();

  // If asked for; what is refuted is taken back.
  void verify(bool closed);

  // All that follows the triangulation.
  ReconstructResult tight_result(const KnownLabelsSource& known);

  CoconeSurface take_surface();
  ReconstructResult take_result();

 private:
  // Where scaling loses bits the surface would be that of other points.
  void require_exact(double scale) const;

  void count_surface();

  // With the peel. None if the surface is certain: then it is delivered.
  std::optional<CellMarks> mark(const KnownLabelsSource& known);
  // Whether a mesh that is none of ours has told labels.
  bool is_told_by_others() const { return told_ && !told_->undisturbed.empty(); }
  bool calls_for_second_look(std::size_t conflicts, std::size_t poor_cells) const;
  // Such a mesh: its marks may have been made again since.
  bool calls_for_look_at_closed(std::size_t conflicts, std::size_t poor_cells) const;
  double cost_of_result() const;
  // Whether the second look is better than the first one, with so many conflicts, and its result is
  // the result now. `cost`: of the surface that is closed already; none: it is not, and marks
  // decide.
  bool look_again(std::size_t conflicts, std::optional<double> cost,
                  const KnownLabelsSource& known);
  // Closes a surface that is better by that, if there is one.
  bool close_with_less(std::size_t conflicts, std::optional<double> cost,
                       const KnownLabelsSource& known);

  // What take_surface() tells of good vertices.
  void keep_good(CellMarks marks);
  // A third as much memory as the triangulation has. What is left of the links is the set of
  // facets.
  void forget_links();

  // All that follows the peel.
  void close_by(CellMarks marks, const KnownLabelsSource& known);
  void deliver(ClosedBody body, const Execution& execution);

  // What close_by() would: nothing is left to be decided.
  void deliver_certain(GoodVertices good, const Execution& execution);

  void deliver(SurfaceMesh surface);

  // The first point at each vertex of the set, ascending. An empty set is one of no vertices.
  std::vector<PointId> points_at(VertexSet vertices) const;

  Points points_;
  ReconstructOptions options_;
  Execution execution_;
  Triangulation own_triangulation_;  // if it was taken over
  const Triangulation* triangulation_ = &own_triangulation_;
  Dual dual_;
  Poles poles_;
  ConeSides sides_;
  BoundarySamples boundary_;
  const LiveStages* live_ = nullptr;  // none: mark_cells, and a mesh
  ManifoldSurface surface_;
  std::optional<KnownLabels> told_;                    // once they were asked for
  VertexSet good_;                                     // as the marks had them
  std::size_t umbrellas_ = 0;                          // of these and those that became poor
  IdVector<VertexId, VertexId> triangulation_vertex_;  // of each vertex of the result
  double scale_ = 1;
  ReconstructResult result_;
  ReconstructStages* stages_ = nullptr;
};

}  // namespace cocoon
