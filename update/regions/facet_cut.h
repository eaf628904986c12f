// The minimum cut of the facets of a model between those that pull to one side and to the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/mesh/halfedges.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"

namespace cocoon {

// What it costs if a facet is not on the source side (> 0) or on the source side (< 0).
struct FacetPull {
  TriangleId facet;
  std::int64_t pull = 0;
};

// What a cut costs between two facets: for each unit of the length of their edge so many steps, and
// so many times as much if one of them is dear.
struct EdgeCosts {
  double steps_per_unit = 1;
  const TriangleSet* dear = nullptr;  // none: no facet is
  double dear_factor = 1;
};

struct FacetCutOptions {
  // At first the cut is looked for among the facets this many steps across edges from those that
  // pull, and among twice as many steps again and again while it is not found there.
  std::size_t first_steps = 3;
};

// The cost of an edge in steps, at least one, at most 2^40.
std::int64_t edge_in_steps(const ModelIndex& model, TriangleId t, std::size_t i,
                           const EdgeCosts& costs);

// 1: on the source side. The labels of the facets off `border` that cost least in all, where a cut
// between two neighbors costs what edge_in_steps() says; of several the ones with the fewest facets
// on the source side. Border facets are on neither side, and not crossed. `pulls`: each facet once,
// none of the border; the sum of all costs fits into 62 bits. The cut among the facets near those
// that pull is the cut of all, if each connected rest lies beside one label only: then the rest has
// that label at no cost, and no labels cost less among the near ones alone. Complexity: for each
// doubling of the steps a pass over the facets and a minimum cut of those near the ones that pull,
// near linear; at last of all facets where a cut is near none. Deterministic: the labels are
// unique.
TriangleSet facet_cut(const ModelIndex& model, const TriangleSet& border,
                      std::span<const FacetPull> pulls, const EdgeCosts& costs,
                      const FacetCutOptions& options = {});

// The edges of a cut: of facets on the source side, to facets that are not, off the border.
// Ascending. Complexity: O(facets).
std::vector<Halfedge> halfedges_of_cut(const ModelIndex& model, const TriangleSet& border,
                                       const TriangleSet& source);

}  // namespace cocoon
