// Places all over a model where nothing was scanned, and whether an updated mesh still passes
// there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/cloud/scan.h"
#include "update/report/lost_triangles.h"

namespace cocoon {

struct ModelPlace {
  Point at;
  TriangleId triangle;
  double area = 0;     // that it stands for
  double reach = 0;    // a mesh passes there if it is no farther than this
  bool large = false;  // its triangle is too large for the scans (AstrayOptions::coarse_ratio)
};

// The middles of the triangles; those of large ones are divided into parts (most_parts), for what
// is lost of them is seldom all. Places near a sample are left out, and all without a spacing. Of
// `options` reach, most_spacings, coarse_ratio and most_parts are used; spacings are the largest of
// the scans. Complexity: O(t log n) for t triangles and n samples, and most_parts^2 times as much
// for large ones. Errors: InputError for options out of range. Source: ours.
std::vector<ModelPlace> unscanned_places(const TriangleMesh& model,
                                         std::span<const TriangleId> triangles,
                                         std::span<const Scan> scans,
                                         const AstrayOptions& options = {});

// Of each place whether the mesh, which has triangles, does not pass there. Complexity: O(log t).
std::vector<std::uint8_t> are_off(std::span<const ModelPlace> places, const TriangleMesh& updated);

}  // namespace cocoon
