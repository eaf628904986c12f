// Samples of clouds by what is known of the updated points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/joined_clouds.h"
#include "update/replace_points.h"

namespace cocoon {

// Of each joined cloud the samples whose updated point has a flag: `flags` are those of
// Replacement::points, and `clouds` those given, which `joined` are made of. Of equal samples only
// the first; those that were left out have none. Complexity: O(updated points + samples). Errors:
// InputError for flags or clouds of another update, by their sizes. Source: ours.
std::vector<std::vector<Point>> samples_with_flag(const Replacement& replacement,
                                                  std::span<const JoinedCloud> joined,
                                                  std::span<const std::vector<Point>> clouds,
                                                  IdVector<PointId, std::uint8_t> flags);

// Of each joined cloud the samples that are no vertices of the updated mesh, of equal ones the
// first. Complexity: O(updated points + samples), O(clouds) if all points are. Source: ours.
std::vector<std::vector<Point>> unused_samples(const Replacement& replacement,
                                               const ReconstructResult& reconstruction,
                                               std::span<const JoinedCloud> joined,
                                               std::span<const std::vector<Point>> clouds);

}  // namespace cocoon
