// Open edges of a model that are closed by its update though no cloud reaches there.
#pragma once

#include <cstddef>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/model/model_index.h"

namespace cocoon {

struct ClosedOpenings {
  std::size_t edges = 0;
  VertexId at = {};  // an end of the first of them
};

// The edges of one triangle whose ends are in the updated mesh, which is closed everywhere: what
// was open there was filled without samples, or left out. `vertex_map`: of the vertices of the
// model (UpdateResult::vertex_map). Complexity: O(1) for a mesh that is known to be smooth
// (ModelIndex::of_smooth()), else O(t log t). Errors: InputError for the map of another model, by
// its size. Source: ours.
ClosedOpenings closed_openings(const ModelIndex& model,
                               const IdVector<VertexId, VertexId>& vertex_map);

}  // namespace cocoon
