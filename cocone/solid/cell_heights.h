// How far cells reach to both sides of a closed mesh.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "cocone/solid/solid_distances.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// Where it is looked how high a cell is.
enum class CellPlaces { centroid, centroid_and_edges };  // edges: at their middles

// The lowest and the highest signed distance of a cell's places from the mesh, and where that is; 0
// if it is only on one side.
struct CellHeights {
  double lowest = 0;
  double highest = 0;
  Point at_lowest;
  Point at_highest;
  double longest_edge = 0;

  // Whether it reaches farther than this part of its longest edge to both sides.
  bool crosses(double min_depth) const {
    return lowest < -min_depth * longest_edge && highest > min_depth * longest_edge;
  }
  // The one that is farther from 0.
  double deepest() const { return -lowest > highest ? lowest : highest; }
};

// How high the centroid of a cell lies, which says how far its other places can reach.
struct CentroidHeight {
  double height = 0;
  double farthest_middle = 0;  // of an edge, from the centroid
  double longest_edge = 0;

  // No middle of an edge is farther than this from the mesh on the side where the centroid is not,
  // for the mesh lies between the two.
  double most_beyond() const {
    constexpr double rounding = 1e-9;
    return (1 + rounding) * farthest_middle - (1 - rounding) * std::abs(height);
  }
};

// Whether the centroid tells all that is asked of a cell.
using IsSettled = std::function<bool(const CentroidHeight&)>;

// The mean of the corners, with the same bits in every order of them. Precondition: finite. O(1).
Point centroid_of(const Triangulation& triangulation, CellId c);

// Of each of these finite cells, at these places; of cells that are settled, at the centroid alone,
// which halves the time where the question is on which side cells lie. `is_settled` may be empty,
// and is called by the calling thread. `solid` is in the coordinates of the triangulation's
// vertices. Throws InputError as signed_distances(); Cancelled. Complexity: O((t + n) log t) for t
// triangles and n cells. Deterministic for any thread count.
std::vector<CellHeights> cell_heights(const Triangulation& triangulation,
                                      std::span<const CellId> cells, const SolidDistances& solid,
                                      CellPlaces places, const IsSettled& is_settled = {},
                                      const Execution& execution = {});

}  // namespace cocoon
