// Pairs of triangles of a mesh that meet where they should not. Exact.
//
// Two triangles of a proper surface meet in what they share: nothing, a corner, or an edge. A pair
// intersects iff it meets in any other point. Corners with equal coordinates are shared, whatever
// their ids, so that a mesh and its unwelded copy have the same pairs. In detail, by the number of
// shared corners:
//   0  any common point counts, a touch included;
//   1  any common point besides the shared corner counts;
//   2  counts iff the triangles lie in one plane, on the same side of the shared edge (one is
//      folded onto the other);
//   3  the same triangle twice (in either orientation): counts.
// Triangles without area (corners on one line) have no interior to cross and are left out.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct SelfIntersectionOptions {
  std::size_t max_pairs = 1000;  // list so many; all are counted
};

struct SelfIntersections {
  std::size_t count = 0;
  std::vector<std::array<TriangleId, 2>> pairs;  // the first ones: smaller id first, sorted
  std::size_t intersecting_triangles = 0;        // triangles in at least one pair
  std::size_t zero_area_triangles = 0;           // left out
  std::size_t tested_pairs = 0;                  // whose boxes overlap

  friend bool operator==(const SelfIntersections&, const SelfIntersections&) = default;
};

// Finds all intersecting pairs of `mesh`. Throws InputError if a triangle names a vertex that is
// not there or has a coordinate that is not finite. Reports progress as "self_intersection".
// Complexity: O(t log t + tested pairs), for triangles of like size near the surface O(t log t).
// Deterministic: exact predicates; counts do not depend on the order of triangles nor on threads.
SelfIntersections self_intersection(const TriangleMesh& mesh,
                                    const SelfIntersectionOptions& options = {},
                                    const Execution& execution = {});

// The test on one pair, as defined above; neither triangle may have its corners on one line.
// Complexity: O(1). Source of the approach: Guigue & Devillers, Fast and robust triangle-triangle
// overlap test using orientation predicates (JGT 2003); here edge against triangle, both ways.
bool triangles_intersect(const std::array<Point, 3>& a, const std::array<Point, 3>& b);

}  // namespace cocoon
