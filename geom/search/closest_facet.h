// The point of a mesh closest to a given point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/search/box_tree.h"
#include "geom/search/facet_bound.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct ClosestFacet {
  TriangleId triangle;
  Point point;  // on the triangle
  double squared_distance = 0;

  friend bool operator==(const ClosestFacet&, const ClosestFacet&) = default;
};

// Search tree over the triangles of a mesh. It keeps its own copy of their corners, so that the
// mesh may go. Degenerate triangles count as the segment or point that they are.
class ClosestFacetTree {
 public:
  // `queries`: about how many points closest() will be asked about; if many more than triangles,
  // memory is spent on that: 144 bytes for each triangle (facet_bound.h). The answers are the same.
  // Throws InputError for a mesh without triangles, with a non-finite coordinate in a triangle, or
  // with a triangle that names a vertex that is not there. Complexity: O(t log t), parallel.
  explicit ClosestFacetTree(const TriangleMesh& mesh, const Execution& execution = {},
                            std::size_t queries = 0);

  // The triangle closest to p. Triangles at equal computed distance (p is closest to their common
  // edge or vertex): the one whose corners, sorted, are lexicographically smallest by coordinates;
  // equal triangles: the smallest id. So the surface alone decides, not the order of its triangles.
  // p must be finite, lengths within those of triangle_projection.h. Complexity: O(log t) for p
  // near the surface, O(t) at worst (p is equally far from all, as the center of a sphere is).
  // Thread-safe.
  ClosestFacet closest(const Point& p) const;

  // The same for points that follow each other closely, where it takes less time: the search begins
  // with the triangle at `slot` (0 at first), which becomes that of the answer.
  ClosestFacet closest(const Point& p, std::uint32_t& slot) const;

  // The squared distance alone, up to its rounding, and from far away in less time: O(log t) also
  // where rounding makes the distances to all triangles equal, but for a mesh that is itself far
  // from the origin, so that rounding is more than its triangles. Otherwise as above.
  double squared_distance(const Point& p) const;

  // Whether that is at most `squared_reach`, up to its rounding: where a triangle is so near the
  // search ends. Complexity: O(log t), and the triangles whose boxes are so near. Thread-safe.
  bool is_within(const Point& p, double squared_reach) const;

 private:
  struct Corners {
    std::array<Point, 3> points;  // sorted: the distance is the same bits in every rotation
    TriangleId triangle;
  };
  BoxTree tree_;
  std::vector<Corners> corners_;    // by slot of the tree
  std::vector<FacetBound> bounds_;  // by slot, or empty
};

}  // namespace cocoon
