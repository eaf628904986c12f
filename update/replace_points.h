// The points of the updated model: what is kept of the old one, and the clouds.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/choose_regions.h"
#include "update/cloud/scan.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/replaced_vertices.h"
#include "update/segment_model.h"

namespace cocoon {

struct Replacement {
  ReplacedVertices vertices;
  // Kept vertices in the order of the model, then the clouds in the order given; of equal points
  // the first one. All coordinates are those of the input.
  std::vector<Point> points;
  // Where a model vertex went; none: removed. Equal vertices share a point.
  IdVector<VertexId, PointId> point_of_vertex;
  // Of each cloud added, where its samples went; none: left out.
  std::vector<IdVector<PointId, PointId>> point_of_cloud_point;
  // Whether each vertex that stays has its own point: these are the first points then.
  bool kept_are_distinct = false;
  std::size_t duplicates = 0;  // points left out because an equal one came before
  std::size_t left_out = 0;    // samples that were to be left out
};

// Replaces the vertices that go by the clouds `added`, but for the samples whose flag in
// `left_out`, for each cloud one of each sample, is not 0; without flags all come in.
// Errors: InputError for vertices that are not ascending or not of the model, and for flags that
// are too few or too many.
// Complexity: O(n) for n points. Deterministic.
// Source: Woo & Dey 2005, section 3.4.
Replacement replace_points(const ModelIndex& model, ReplacedVertices vertices,
                           std::span<const std::vector<Point>> added,
                           std::span<const SampleFlags> left_out = {});

// The same with those of replaced_vertices(). `added`: what comes in, the samples of `clouds` in
// the order wanted. It is another list than `clouds` only where several clouds are taken as one
// (joined_clouds.h): `clouds` has those that were joined, `added` those that were given.
// Errors: those of both. Complexity: O(n) for n points and triangles, and a search per border
// vertex.
Replacement replace_points(const ModelIndex& model, const Regions& regions,
                           const RegionChoice& choice, std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds,
                           std::span<const std::vector<Point>> added,
                           const ReplaceOptions& options = {}, const SaidVertices& said = {});

}  // namespace cocoon
