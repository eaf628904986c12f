#include "cocone/kept/kept_stages.h"

#include <utility>

namespace cocoon {

void KeptStages::start(const Triangulation& triangulation, const ReconstructStages& stages,
                       const Execution& execution) {
  if (stages.out.empty()) return;
  marks.keep(stages.marked, stages.marks);
  body.resume(triangulation, stages.out, execution);
}

void KeptStages::resume(const Triangulation& triangulation, SurfaceState state) {
  marks.resume(std::move(state.marks));
  if (!state.out.empty()) body.resume(triangulation, state.out);
}

void KeptStages::update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                        const LiveCandidates& candidates) {
  if (links.exists()) links.update(delaunay, change);
  if (marks.exists()) marks.update(delaunay, change, candidates);
  if (body.exists()) body.update(delaunay, change);
}

void KeptStages::renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay) {
  if (links.exists()) links.renumber(renumbering, delaunay);
  if (marks.exists()) marks.renumber(renumbering, delaunay);
  if (body.exists()) body.renumber(renumbering, delaunay);
}

}  // namespace cocoon
