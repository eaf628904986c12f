// Whether a model has hollows inside.
#pragma once

#include "update/model/model_index.h"

namespace cocoon {

// Whether a part of the model, connected by edges, faces inward: its volume is negative. In a model
// that faces outward (orient_outward.h) that is the wall of a hollow. Complexity: O(triangles),
// O(1) if the model is connected.
bool has_hollow(const ModelIndex& model);

}  // namespace cocoon
