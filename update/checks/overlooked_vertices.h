// Vertices of the model in the midst of a cloud, of regions that stay: a sign that its rim was not
// found whole.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/search/nearest_point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"

namespace cocoon {

struct OverlookedOptions {
  // A vertex has been scanned anew if a sample is as close as this share of the median edge of the
  // cloud's surface. (ScannedOptions::sample_reach is a share of the model's spacing.)
  double reach = 0.36;
  // It is overlooked if regions keep it and it is farther from the rims than this many of these
  // edges.
  double min_rim_distance = 3;
  // Fewer of them mean nothing: a thin wall, a fold of the rim. Measured on scans of parts: 0 to 6
  // after updates that went right, 15 to 250 where a part of the cloud lay on a region that stayed.
  std::size_t min_count = 8;
  // Of all vertices that have been scanned anew, near the rims or not, a larger share that stays is
  // a sign that the rims run through what was scanned, wherever they are. Of 506 updates that went
  // right one has a larger share: 19 of its 55 vertices. Infinity: any share may stay.
  double max_kept_share = 0.3;
  // Fewer of them mean nothing: small scans have as many beside their rims.
  std::size_t min_kept = 16;
  // Those that are overlooked go, if they are many (scanned_again.h).
  bool go = true;
};

struct OverlookedVertices {
  std::vector<VertexId> vertices;  // ascending
  std::size_t scanned = 0;         // anew, near the rims or not, whether they stay or go
  std::size_t kept = 0;            // of these, all that regions keep
  VertexId farthest = {};  // of those kept: the one farthest from the rims, of several the first

  bool are_many(const OverlookedOptions& options) const {
    return vertices.size() >= options.min_count;
  }
  bool are_large_share(const OverlookedOptions& options) const {
    return kept >= options.min_kept &&
           static_cast<double>(kept) > options.max_kept_share * static_cast<double>(scanned);
  }
  bool is_doubtful(const OverlookedOptions& options) const {
    return are_many(options) || are_large_share(options);
  }
};

// Which vertices of the model stay although they have been scanned anew far from the rim. Where
// a cloud lies on the model as it was, both have the same surface, and the old samples of it go; so
// there are none unless a part of the rim is missing, or the wrong region was chosen. They show
// regions that stay wrongly, not those that go wrongly. Where all of a rim is wrong, as that of a
// thin plate's scan that is torn at the mouths of a hole, no vertex is far from it, but many of the
// scanned ones stay.
// clouds[i]: the samples of the cloud of rims[i], those that formed the border. `removed`: the
// vertices that go, ascending.
// Complexity: O(v log n) for v vertices and n samples. Deterministic. Errors: InputError for
// options out of range, if not every rim has a tree, and for vertices that are not ascending or
// not of the model. Source: ours.
OverlookedVertices overlooked_vertices(const ModelIndex& model, std::span<const VertexId> removed,
                                       std::span<const CloudRim> rims,
                                       std::span<const NearestPointTree> clouds,
                                       const OverlookedOptions& options = {});

}  // namespace cocoon
