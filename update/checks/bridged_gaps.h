// Gaps of a scan that the updated surface bridges where the model has changed.
#pragma once

#include <cstddef>
#include <span>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/search/nearest_point.h"
#include "geom/triangle_mesh.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"

namespace cocoon {

struct GapOptions {
  // A triangle bridges a gap if an edge of it is longer than this many spacings: of the samples at
  // its corners or, if that is more, of the model where their rims lie on it.
  double reach = 3;
  // And if its centroid is farther from the model than this many: the old surface tells of its own
  // place what samples do not.
  double off_model = 0.5;
};

struct BridgedGaps {
  std::size_t triangles = 0;
  double longest = 0;  // edge of them, in spacings
  Point at = {};       // its middle; of equally long ones the lexicographically smallest
};

// Triangles of the updated surface that bridge a gap: what lies there nobody saw, as behind the
// brim of a pocket or in the shadow of a boss, and the surface is a guess. Only those with a sample
// among their corners are looked at.
// `vertices`: of the updated surface, those from `first_new` on samples; `triangles`: all that
// have such a vertex, and others, perhaps. samples[c]: those of scans[c]; spacings[c]: as in
// GapOptions::reach. Complexity: O(t), and O(log n) for n samples and what NearFacets takes if
// edges are long. Deterministic, whatever the order. Errors: InputError for options out of range,
// or if scans, trees and spacings are not equally many. Source: ours.
BridgedGaps bridged_gaps(const ModelIndex& model, Points vertices,
                         std::span<const Triangle> triangles, VertexId first_new,
                         std::span<const NearestPointTree> samples,
                         std::span<const double> spacings, const GapOptions& options = {});

// The spacing of a scan or, if that is more, the median edge of the model's `facets` (the median of
// the median edge of each). Complexity: O(facets).
double spacing_at(const ModelIndex& model, const Scan& scan, std::span<const TriangleId> facets);

}  // namespace cocoon
