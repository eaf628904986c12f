// Samples that show a change and are not on the updated surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/point.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"

namespace cocoon {

// Distances in spacings of the sample's scan.
struct UnusedChangeOptions {
  // A sample farther from the model than this shows a change.
  double off_model = 0.7;
  // An unused sample with fewer other ones around it is a stray point, no change.
  std::size_t neighbors = 3;
  // How far around.
  double reach = 2;
  // A larger share of the samples off the model is worth a warning. Of 463 updates one of 247 right
  // ones had such a share, and half of 216 wrong ones.
  double min_share = 0.02;
  // So many of them are worth one, whatever their share.
  std::size_t min_count = 50;
};

struct UnusedChanges {
  std::size_t samples = 0;  // off the model, not on the surface, and no stray points
  std::size_t of = 0;       // samples off the model, of the scans with such unused ones only
  Point at = {};            // one of the unused

  bool is_doubtful(const UnusedChangeOptions& options) const {
    return samples >= options.min_count ||
           static_cast<double>(samples) > options.min_share * static_cast<double>(of);
  }
};

// unused[i]: the samples of scans[i] that are not on the updated surface. Why: where the wrong part
// of the model stays, the samples of the change lie inside the body or hang in the air.
// Complexity: O(n log n) for n samples, and what NearFacets takes; O(scans) if all are used.
// Deterministic. Errors: InputError for options out of range, or if
// not every scan has its list. Source: ours.
UnusedChanges unused_changes(const ModelIndex& model, std::span<const Scan> scans,
                             std::span<const std::vector<Point>> unused,
                             const UnusedChangeOptions& options = {});

}  // namespace cocoon
