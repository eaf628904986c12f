// The overlapping facets joined to closed bands: no gap between the facets of consecutive rim
// points, so that growing a region across edges cannot leak through the border.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"
#include "update/overlapping_facets.h"

namespace cocoon {

struct TraceOptions {
  // A straight walk over more facets than this has lost its way.
  std::size_t max_walk_facets = 200;
  // The search that replaces a failed walk looks at no more facets than this. Where a scan breaks
  // off at a sharp edge of a part with tubes and ribs, the way around is long.
  std::size_t max_search_facets = 200000;
};

// The facets under one loop, edge by edge.
struct LoopBorder {
  // facets_of(i): the facets under E_i in the order of the walk, from that of b_i to that of b_i+1
  // included. Empty for an edge with an end that has no facet, or where no way was found. A stretch
  // of points without a facet is bridged by one walk; its facets are of the band but of no edge.
  std::span<const TriangleId> facets_of(std::size_t i) const {
    return std::span(facets).subspan(begin[i], begin[i + 1] - begin[i]);
  }
  // Calls visit(TriangleId) for all of the band, as often as the walks met them.
  template <class Visit>
  void for_each_facet(Visit visit) const {
    for (const TriangleId t : facets) visit(t);
    for (const TriangleId t : bridges) visit(t);
  }
  std::vector<std::uint32_t> begin;  // edges + 1
  std::vector<TriangleId> facets;
  std::vector<TriangleId> bridges;  // under stretches of points without a facet
  bool closed = true;               // false: no way over the model between two consecutive points
};

struct BorderFigures {
  std::size_t facets = 0;
  std::size_t walks = 0;     // straight walks that arrived
  std::size_t searches = 0;  // walks that failed and were replaced by a search
  std::size_t breaks = 0;    // searches that failed, too
};

struct Border {
  TriangleSet facets;             // the union of all bands
  std::vector<LoopBorder> loops;  // as in the rim; empty for a loop that is not on_model
  BorderFigures figures;
};

// Walks over the model from the facet of each rim point to that of the next one.
// A walk follows the plane through the feet of both points that contains the mean of the two facet
// normals, and leaves each facet by the edge that the plane crosses; a corner that lies on the
// plane counts as lying above it, so that every facet has exactly two crossed edges or none. A walk
// that fails gives way to a shortest path over neighboring facets, where a step costs the distance
// between centroids and twice the distance of the new centroid from the segment. Both step across
// edges only: a band is connected by edges, and closed unless `breaks` is above 0.
// Errors: InputError unless the overlap has the loops of the rim. Complexity: O(facets walked), O(s
// log s) for a search over s facets. Ties by lexicographic corners.
// Source: not treated in Woo & Dey 2005, section 3.3 (a cloud coarser than the model leaves gaps).
Border trace_border(const ModelIndex& model, const CloudRim& rim, const Overlap& overlap,
                    const TraceOptions& options = {}, const Execution& execution = {});

}  // namespace cocoon
