// Whether a model has hollows inside.
#pragma once

#include "cocone/reconstruct.h"
#include "update/model/model_index.h"

namespace cocoon {

// Whether a part of the model, connected by edges, faces inward: its volume is negative. In a model
// that faces outward (orient_outward.h) that is the wall of a hollow. Complexity: O(triangles),
// O(1) if the model is connected.
bool has_hollow(const ModelIndex& model);

// Whether an update of the model keeps closed surfaces inside the body as bounds of hollows: where
// that is asked for, or the model has hollows. Complexity: as has_hollow().
inline bool keeps_cavities(const ReconstructOptions& options, const ModelIndex& model) {
  return options.keep_cavities || has_hollow(model);
}

}  // namespace cocoon
