// The rims of all clouds in one search tree: which rim edge is nearest, and on which side of the
// rim a point lies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/point.h"
#include "geom/search/box_tree.h"
#include "update/cloud_rim.h"

namespace cocoon {

// Where a point lies to the rim edge nearest to it.
struct RimSide {
  double distance = 0;
  std::uint32_t rim = 0;       // the first rim that has such an edge
  bool on_cloud_side = false;  // the wedge angle between its cocone triangle and the point is acute
  bool at_partial_loop = false;  // the first loop that has such an edge has inner ones, too
};

// Copies what it needs of the rims. Safe to query from many threads.
// Source: ours, docs/stages/replace_points.md; the wedge angle is that of Woo & Dey 2005,
// section 3.4.
class RimIndex {
 public:
  // Edges with cloud beyond them (RimLoop::inner) are left out: they are no end of the cloud.
  // Complexity: O(n log n) for n rim edges.
  explicit RimIndex(std::span<const CloudRim> rims);

  bool empty() const { return edges_.empty(); }
  // The side of the rim edge nearest to p: p lies on the cloud's if the wedge angle between the
  // edge's cocone triangle and p is below pi / 2. Where an end of edges is what is nearest, the
  // sides of all edges that end there are added up. Ties by rim order. No rim: infinitely far,
  // on the other side. Complexity: O(log n) on ordinary rims.
  RimSide side_of(const Point& p) const;

 private:
  struct Edge {
    Point from;
    Point to;
    Vec3 inward;  // unit, orthogonal to the edge, towards the apex
    std::uint32_t rim;
    bool of_partial_loop;
  };
  std::vector<Edge> edges_;
  BoxTree tree_;
};

}  // namespace cocoon
