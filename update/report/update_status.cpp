#include "update/report/update_status.h"

namespace cocoon {

std::string_view name_of(UpdateStatus status) {
  switch (status) {
    case UpdateStatus::ok:
      return "ok";
    case UpdateStatus::no_cloud_surface:
      return "no_cloud_surface";
    case UpdateStatus::cloud_closed:
      return "cloud_closed";
    case UpdateStatus::no_overlap:
      return "no_overlap";
    case UpdateStatus::non_separating:
      return "non_separating";
    case UpdateStatus::ambiguous:
      return "ambiguous";
    case UpdateStatus::empty_surface:
      return "empty_surface";
    case UpdateStatus::refuted:
      return "refuted";
  }
  return "unknown";
}

}  // namespace cocoon
