// Which way the surface of a cloud faces at its samples.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geom/point.h"
#include "update/cloud_surface.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"

namespace cocoon {

// Out of the body, at a sample.
struct Outward {
  Vec3 normal;  // unit; the zero vector if it is not known
  // Of a normal that is presumed the direction from which it was seen, unit: there is nothing but
  // air that way, while walls around, which may not have been seen, need not be known. Else zero.
  Vec3 view = {};

  bool is_presumed() const { return view != Vec3{}; }

  friend bool operator==(const Outward&, const Outward&) = default;
};

// Those of the samples of a cloud, by its number. Asked for where they matter: in most updates
// nowhere.
using OutwardNormals = std::function<std::vector<Outward>(std::size_t cloud)>;

struct OutwardOptions {
  // A part of the surface that hangs outside of the model faces away from it, or toward it, if its
  // mean cosine with the way there, which counts as 0 where it is inside, is more than this.
  double min_part_cosine = 0.5;
  // There is a direction from which the scan was seen if the normals of the model at the points of
  // the rim add up to this share of their number. More than 1: there is none.
  double min_agreement = 0.5;
  // A triangle of which nothing else is known faces that direction, or turned over does, if the
  // cosine is more than this.
  double min_view_cosine = 0.3;
};

// Of the samples of `cloud`. What is outside the model tells: each part of the surface that hangs
// together by edges faces as the model does at the loops that lie on it, by the sign of the sum of
// cosines there. Parts without such a loop that hang outside of the model face away from it, if
// they do so clearly one way or the other: scanners see what faces them, and seldom the room below.
// For the same reason triangles of one-sided parts and of others, as the floor of a pocket, are
// presumed to face the direction from which the scan was seen: that of the sum of the model's
// normals at the rim, if these agree. The zero vector where nothing is known: for samples that are
// no vertices of the surface, and where the surface is steep or the normals at the rim disagree.
// The overlap is that of the surface's rim. Errors: InputError for options out of range.
// Complexity: O(samples), and what closest_facets() takes for parts without a loop. Deterministic:
// independent of the numbering and orientation of the surface's triangles up to rounding. Source:
// ours.
std::vector<Outward> outward_normals(const ModelIndex& model, Points cloud,
                                     const CloudSurface& surface, const Overlap& overlap,
                                     const OutwardOptions& options = {});

}  // namespace cocoon
