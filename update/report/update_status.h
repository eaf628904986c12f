// How an update may end.
#pragma once

#include <string_view>

namespace cocoon {

// Outcomes that depend on the data; none is an exception. All but ok leave the mesh empty and the
// result filled as far as the work went.
enum class UpdateStatus {
  ok,
  no_cloud_surface,  // a cloud gives no surface: too few or too noisy samples
  cloud_closed,      // a cloud has no rim: it is a body of its own, not a patch
  no_overlap,        // a cloud's rim does not lie on the model
  non_separating,    // a cloud's rim does not cut the model in two, nor does a cut
  ambiguous,         // the angles do not tell which region lies under a cloud
  empty_surface,     // nothing is left of the updated points' reconstruction
  refuted,           // its verification failed (ReconstructOptions::verify)
};

// "ok", "no_overlap", ...: the names of the enumerators.
std::string_view name_of(UpdateStatus status);

}  // namespace cocoon
