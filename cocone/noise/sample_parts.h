// Parts of a cloud: samples that hang together, from each to the next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

struct SampleParts {
  IdVector<VertexId, VertexId> part;     // of each vertex: the smallest vertex of its part
  IdVector<VertexId, std::size_t> size;  // at this one: samples of the part; elsewhere 0
  std::size_t largest = 0;               // the most of these
};

// Whether two Delaunay neighbors hang together: each is within the reach of the other. O(1).
inline bool is_linked(const Triangulation& triangulation, const IdVector<VertexId, double>& reach,
                      VertexId v, VertexId w) {
  const double length = distance(triangulation.point(v), triangulation.point(w));
  return length <= std::min(reach[v], reach[w]);
}

// What links hold together; those with apart[v] = 1 are parts by themselves (`apart` empty: none).
// Complexity: O(cells). Which samples are together is a function of the points.
SampleParts sample_parts(const Triangulation& triangulation,
                         const IdVector<VertexId, double>& reach, const VertexSet& apart = {});

// Of each of these vertices: its spacing (noise_filter.h), but at least the median (the upper one
// of two) of its Delaunay neighbors'. Two samples that happen to be close then still reach the
// others around them. Of others 0. Complexity: O(vertices + stars) expected, parallel.
IdVector<VertexId, double> usual_spacing(const Triangulation& triangulation,
                                         const VertexStars& stars,
                                         const IdVector<VertexId, double>& spacing,
                                         std::span<const VertexId> vertices,
                                         const Execution& execution = {});

}  // namespace cocoon
