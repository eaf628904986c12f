// Vertices of the model that an update loses though nothing was scanned near them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/search/nearest_point.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/replace_points.h"

namespace cocoon {

struct UnscannedOptions {
  // Nothing was scanned near a vertex if each sample is farther away than this many spacings: the
  // median edge of the sample's cloud, or the mean edge of the model at the vertex, if that is
  // more.
  double reach = 3;
  // A sample farther from the model than this many spacings shows that it was changed there (as
  // ScanEndOptions::off_model).
  double off_model = 0.5;
  // Such samples within this many spacings of where it begins explain what went: a boss that was
  // taken off leaves its place.
  double change_reach = 5;
  // At this share of the vertices where it begins, at least; if handles went, at each of its ends.
  double explained = 0.5;
  // But nothing explains that more than this share of the model goes so.
  double max_explained_share = 0.5;
};

// The vertices of the model's triangles that are not in the updated mesh, ascending. `vertex_map`:
// where they are in it, looked at only unless `all_used`: all updated points are in it. Errors:
// InputError for the map of another model, by its size. Complexity: O(found), else O(v).
std::vector<VertexId> lost_vertices(const ModelIndex& model, const Replacement& replacement,
                                    const IdVector<VertexId, VertexId>& vertex_map, bool all_used);

struct UnscannedLosses {
  std::size_t far = 0;       // lost vertices with no sample near them
  std::size_t vertices = 0;  // of these, with nothing that explains it
  // Of those the one farthest from all samples (of several the first), and how far, in spacings.
  VertexId farthest = {};
  double distance = 0;
};

// Of the lost vertices those that no sample is near. That is as it should be where material was
// taken away or filled in: samples off the model lie around. Where all samples around lie on the
// model, something went that nobody scanned: an island in a scan whose rim was not found, what was
// left over and no longer makes a surface. If handles went, or parts came (`lost_handles`: the
// Euler characteristic rose), samples must lie around all ends of what went, and nothing beside
// it may stay: a handle that begins under the cloud may end where nothing was scanned. Vertices
// that hang together by edges of the model went for one reason. samples[i]: those of scans[i].
// Complexity: O(log n) for n samples for each lost vertex and its triangles; O(n) and what
// NearFacets takes if any is far. Deterministic. Errors: InputError for options out of range, or if
// not every scan has a tree.
// Source: ours.
UnscannedLosses unscanned_losses(const ModelIndex& model, std::span<const VertexId> lost,
                                 std::span<const Scan> scans,
                                 std::span<const NearestPointTree> samples, bool lost_handles,
                                 const UnscannedOptions& options = {});

}  // namespace cocoon
