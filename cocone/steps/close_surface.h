// The steps of Tight Cocone: marks, a second look where they contradict each other, and the body.
#pragma once

#include <cstddef>

#include "cocone/facet_set.h"
#include "cocone/known_labels.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/steps/find_surface.h"
#include "cocone/steps/surface_result.h"
#include "geom/execution.h"

namespace cocoon {

// Who goes on from what is found on the way.
struct GoingOn {
  const LiveStages* live = nullptr;     // marks cells, and is asked to take the body
  ReconstructStages* stages = nullptr;  // get the marks before the peel, and the body
};

// As CoconeSurface has them.
struct GoodUmbrellas {
  VertexSet good;
  std::size_t umbrellas = 0;
};

// Marks the cells, peels and cleans up, and enters the closed surface, or has `live` take the body.
// Where the surface is certain (certain_surface.h) it is entered as it is. Where marks contradict
// each other there is a second look (second_look.h): if that is better, `made` is of it. `found`
// stays that of the first look, less what nobody needs any more: the links of its facets are left
// to `live` only. Returns the vertices that the marks of the first look took for good.
// `known` is asked once at most (reconstruct.h). Errors, complexity and progress: those of the
// stages. Source: Dey & Goswami 2003; ours, docs/stages/mark_cells.md.
GoodUmbrellas close_surface(const ReconstructInput& input, FoundSurface& found,
                            const KnownLabelsSource& known, const GoingOn& going_on,
                            SurfaceResult& made, const Execution& execution);

}  // namespace cocoon
