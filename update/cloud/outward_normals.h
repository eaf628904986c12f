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

// Those of the samples of a cloud, by its number. Asked for where they matter: in most updates
// nowhere.
using OutwardNormals = std::function<std::vector<Vec3>(std::size_t cloud)>;

// Unit normals of the samples of `cloud`, out of the body. What is outside the model tells: each
// part of the surface that hangs together by edges faces as the model does at the loops that lie on
// it, by the sign of the sum of cosines there. Parts without such a loop that hang outside of the
// model face away from it, if they do so clearly one way or the other: scanners see what faces
// them, and seldom the room below. The zero vector where nothing is known: for samples that are no
// vertices of the surface, on other parts without such a loop, and on one-sided ones. The overlap
// is that of the surface's rim. Complexity: O(samples), and what closest_facets() takes for parts
// without a loop. Deterministic: independent of the numbering and orientation of the surface's
// triangles up to rounding. Source: ours.
std::vector<Vec3> outward_normals(const ModelIndex& model, Points cloud,
                                  const CloudSurface& surface, const Overlap& overlap);

}  // namespace cocoon
