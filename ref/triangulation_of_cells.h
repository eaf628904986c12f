// From a plain list of tetrahedra to the project's Triangulation: the step that all reference
// triangulations share. Nothing is assumed about how the tetrahedra were found.
#pragma once

#include <array>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/point.h"

namespace cocoon::ref {

// Different points in lexicographic order (their place is their vertex id), and where each input
// point went. Of equal points (-0.0 equals 0.0) the first one's bits are kept.
struct DistinctPoints {
  IdVector<VertexId, Point> points;
  IdVector<PointId, VertexId> vertex_of_point;
};

// Errors: InputError for a coordinate that is not finite, and for fewer than four different points.
// Complexity: O(n log n).
DistinctPoints distinct_points(Points points);

// Builds adjacency and infinite cells for `cells`: positively oriented tetrahedra that fill the
// convex hull of `distinct.points` without overlap. Facets are matched by their sorted vertices; a
// facet that occurs once is on the hull. Result in a canonical order: vertices of a cell ascending
// up to the parity that orientation demands, cells ascending by vertices.
// Errors: InputError if a facet occurs more than twice. Complexity: O(n log n).
Triangulation triangulation_of_cells(DistinctPoints distinct,
                                     std::vector<std::array<VertexId, 4>> cells);

}  // namespace cocoon::ref
