// What is kept of the stages from the extraction on while the surface is not certain.
#pragma once

#include "cocone/extract_manifold.h"
#include "cocone/kept/kept_body.h"
#include "cocone/kept/kept_links.h"
#include "cocone/kept/kept_marks.h"
#include "cocone/live/live_candidates.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/live/surface_state.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/renumbering.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Each part may be there or not.
struct KeptStages {
  KeptLinks links;
  KeptMarks marks;
  KeptBody body;
  FirstWalk first_walk = FirstWalk::at_once;

  void clear() { *this = {}; }
  // Begins with marks and body as the stages found them, or as they were known, in this
  // triangulation. Precondition: neither is there. Complexity: O(n).
  void start(const Triangulation& triangulation, const ReconstructStages& stages,
             const Execution& execution = {});
  void resume(const Triangulation& triangulation, SurfaceState state);
  // After a change of the triangulation and of the candidates, and when gaps are closed.
  // Complexity: O(change).
  void update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
              const LiveCandidates& candidates);
  void renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay);
};

}  // namespace cocoon
