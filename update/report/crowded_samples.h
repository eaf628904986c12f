// Samples that lie closer together than the vertices of the model: in layers, often.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/model/model_index.h"

namespace cocoon {

struct CrowdedOptions {
  // As a share of the median edge at the vertices that went.
  double distance = 0.62;
  // Of all samples, fewer mean nothing.
  double min_share = 0.25;
  // They lie in layers if they are as thick (layers.h), around those that keep the distance.
  double min_thickness = 0.13;
  // If they are many and lie in layers, whether a surface without them is tried, too.
  bool leave_out = true;
};

struct CrowdedSamples {
  double distance = 0;
  std::size_t closer = 0;  // would have to go so that the others keep it (thin_points)
  std::size_t of = 0;      // samples in all
  double thickness = 0;
  std::vector<IdVector<PointId, std::uint8_t>> is_closer;  // for each cloud, of each sample

  bool are_many(const CrowdedOptions& options) const {
    return closer > 0 && static_cast<double>(closer) >= options.min_share * static_cast<double>(of);
  }
  bool are_in_layers(const CrowdedOptions& options) const {
    return are_many(options) && thickness >= options.min_thickness;
  }
};

// How many samples of all clouds lie closer to others than a distance that the model does without.
// Views out of register and noise make layers of them, with handles, hollows and shreds between:
// where the surface has such, it may help to leave these samples out, which a finer scan of a true
// detail would miss. `removed`: the vertices that went. Complexity: O(n log n) for n samples.
// Deterministic. Errors: InputError for options out of range, and for vertices that are not of the
// model. Source: ours, docs/update.md, departure 25.
CrowdedSamples crowded_samples(const ModelIndex& model, std::span<const VertexId> removed,
                               std::span<const std::vector<Point>> clouds,
                               const CrowdedOptions& options = {});

}  // namespace cocoon
