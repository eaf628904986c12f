// Which vertices of the model close to the rims of clouds have been scanned anew.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/arrays/sparse_vector.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/cloud/rim_index.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"

namespace cocoon {

struct ScannedOptions {
  // A vertex at the border that is closer to the rim than this many spacings, of rim or model,
  // whichever is larger, lies so near to it that samples tell more than the rim does. 0 = off. The
  // spacing of the model is its mean edge around the vertex and its neighbors at the border.
  double rim_zone = 0.27;
  // There it has been scanned anew iff a sample is close enough. At the rim: as close as this share
  // of the model's spacing,
  double sample_reach = 0.35;
  // or of the median edge of the cloud's surface, if that is more: the samples of a coarse cloud
  // are far from most of what was scanned.
  double cloud_reach = 0.62;
  // Before the rim at most so many spacings of it count: a vertex of a model with large triangles
  // has none as close as its own, and would go for samples far away.
  double outer_reach = 2;
  // On the cloud's side of the rim a sample may be farther away, before it it must be closer: by
  // this share of that for each spacing of the model between vertex and rim.
  double depth_weight = 1.3;
};

enum class Scanned : std::uint8_t {
  unclear,  // not at the border or not close to a rim: regions and sides of rims decide
  no,
  yes,
};

// One value for each vertex of the model, unclear for most. The rim is a chain of chords between
// samples: it cuts off what juts out and spans dents, in which nothing was scanned; and a cloud
// that is not quite registered has its rim beside where it belongs. Then a vertex that nobody
// scanned again would go, or one stay beside the sample that replaces it. rims[i] belongs to
// clouds[i]; `rim_index` is that of the rims. Complexity: a search per cloud point and border
// vertex, and what SparseVector takes to find those. Deterministic. Source: ours; the thresholds
// separate right from wrong vertices in `./dev bench update_scores`.
SparseVector<VertexId, Scanned> scanned_vertices(const ModelIndex& model, const Regions& regions,
                                                 const RimIndex& rim_index,
                                                 std::span<const CloudRim> rims,
                                                 std::span<const std::vector<Point>> clouds,
                                                 const ScannedOptions& options = {});

}  // namespace cocoon
