// Open edges of a model that are closed by its update without samples.
#pragma once

#include <cstddef>
#include <span>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"
#include "update/model/irregular_sides.h"
#include "update/model/model_index.h"

namespace cocoon {

struct ClosedOpeningOptions {
  // A sample fills an opening beside an edge if a triangle of the two is in the updated mesh, and
  // the sample is not farther from the middle of the edge than this many times its length.
  double reach = 3;
};

struct ClosedOpenings {
  std::size_t edges = 0;
  VertexId at = {};  // an end of the first of them, as the model numbers it
};

// The edges of one triangle of the model whose ends are both vertices of the updated mesh, which is
// closed everywhere, where no sample of a cloud fills the opening. `irregular`: irregular_sides()
// of the model; `updated`, `vertex_map`: the mesh and where the vertices of the model are in it
// (UpdateResult). Complexity: O(t log k) for t triangles and k open edges, O(1) for none. Errors:
// InputError for the map of another model, by its size, and a reach out of range. Source: ours.
ClosedOpenings closed_openings(const ModelIndex& model, std::span<const EdgeSide> irregular,
                               const TriangleMesh& updated,
                               const IdVector<VertexId, VertexId>& vertex_map,
                               const ClosedOpeningOptions& options = {});

}  // namespace cocoon
