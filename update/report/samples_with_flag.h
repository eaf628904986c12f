// Samples of clouds by what is known of the updated points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/joined_clouds.h"
#include "update/replace_points.h"

namespace cocoon {

// Of each joined cloud the samples whose updated point has a flag: `flags` are those of
// Replacement::points, and `clouds` those given, which `joined` are made of. Of equal samples only
// the first. Complexity: O(updated points + samples). Source: ours.
std::vector<std::vector<Point>> samples_with_flag(const Replacement& replacement,
                                                  std::span<const JoinedCloud> joined,
                                                  std::span<const std::vector<Point>> clouds,
                                                  IdVector<PointId, std::uint8_t> flags);

}  // namespace cocoon
