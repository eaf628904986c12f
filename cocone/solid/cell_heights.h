// How far cells reach to both sides of a closed mesh.
#pragma once

#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

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

// Of each of these finite cells, at these places. `solid` is in the coordinates of the
// triangulation's vertices. Throws InputError as signed_distances(); Cancelled. Complexity: O((t +
// n) log t) for t triangles and n cells. Deterministic for any thread count.
std::vector<CellHeights> cell_heights(const Triangulation& triangulation,
                                      std::span<const CellId> cells, const TriangleMesh& solid,
                                      CellPlaces places, const Execution& execution = {});

}  // namespace cocoon
