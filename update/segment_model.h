// The model cut into regions along the border, and its vertices into groups.
#pragma once

#include <cstddef>

#include "geom/arrays/sparse_vector.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"

namespace cocoon {

struct SegmentOptions {
  // A region with fewer facets, cut off by the border among larger ones, becomes part of it.
  std::size_t min_region_facets = 4;
};

struct Region {
  TriangleId first;  // its lowest facet
  std::size_t facets = 0;
  std::size_t vertices = 0;  // of its group
};

struct Regions {
  IdVector<RegionId, Region> regions;  // by lowest facets; cut_regions() appends
  // Most facets and vertices are of one region: that of the model's rest.
  SparseVector<TriangleId, RegionId> region_of_facet;  // none: a facet of the border
  // none: a border vertex, at facets of several regions or of the border only; or a vertex that no
  // triangle uses.
  SparseVector<VertexId, RegionId> group_of_vertex;
  std::size_t border_facets = 0;    // with those of merged islands
  std::size_t border_vertices = 0;  // used vertices without a group
  std::size_t merged_islands = 0;
};

// The components of model \ border under adjacency across edges. A vertex belongs to the group of
// a region if all facets at it that are not in the border are of that region, and there is one.
// Where every region is tiny, none is merged away.
// Errors: InputError unless the border has a flag for each facet. Complexity: O(triangles +
// vertices). Deterministic: by facet id.
// Source: Woo & Dey 2005, section 3.4.
Regions segment_model(const ModelIndex& model, const TriangleSet& border,
                      const SegmentOptions& options = {}, const Execution& execution = {});

// Overload for a mesh without an index: builds the ModelIndex first, O(t + v).
Regions segment_model(const TriangleMesh& model, const TriangleSet& border,
                      const SegmentOptions& options = {}, const Execution& execution = {});

// Fills in all of `regions` but its islands from region_of_facet, for as many regions as there are.
// For those who change region_of_facet. Errors: InputError unless that has an entry for each facet.
// Complexity: O(triangles + vertices).
void count_and_group(const ModelIndex& model, Regions& regions);

}  // namespace cocoon
