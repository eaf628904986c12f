// The samples of a cloud, how far apart they lie, and how far off their place.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// One for each sample of a cloud.
using SampleFlags = IdVector<PointId, std::uint8_t>;

struct Scan {
  Points samples;      // a view: who owns them must outlive it
  double spacing = 0;  // of the samples: the median edge of their surface
  Vec3 shift = {};     // of all, off their place, as far as is known (CloudReport::believed_shift)
};

// 0 without scans. O(1) for each.
inline double largest_spacing(std::span<const Scan> scans) {
  double spacing = 0;
  for (const Scan& scan : scans) spacing = std::max(spacing, scan.spacing);
  return spacing;
}

}  // namespace cocoon
