// The two sides of a loop's band of facets, and whether the loop separates the model at all.
#pragma once

#include <cstddef>
#include <vector>

#include "geom/ids.h"
#include "geom/mesh/triangle_neighbors.h"
#include "geom/triangle_mesh.h"
#include "update/segment_model.h"
#include "update/trace_border.h"

namespace cocoon {

struct LoopSide {
  std::size_t edges = 0;  // length of this boundary curve of the band
  RegionId region;        // the region that most of it borders on; none if it borders on none
};

enum class Separation {
  separates,         // different regions on the two long sides
  encloses_nothing,  // one side only borders on a region: no facet lies inside the loop
  non_separating,    // the same region on both sides: the loop runs around a handle
  open_band,         // the band has a break: the rim jumps between parts of the model
};

struct LoopSides {
  Separation separation = Separation::separates;
  std::vector<LoopSide> sides;  // longest first, of equal ones that at the larger region
};

// The boundary curves of the band are its sides; where the band touches itself at a vertex, curves
// pass through it one by one. On a model of the topology of a sphere different sides never share a
// region; on one with handles they do iff the loop does not cut the model in two, alone or together
// with the other loops. Only the two longest sides that border on a region count: short ones are
// pockets where the band touches itself.
// Complexity: O(b log b) for a band of b facets.
// Source: Woo & Dey 2005, section 3.4 presumes one region more than loops, which holds on spheres.
LoopSides loop_sides(const TriangleMesh& model, const TriangleNeighbors& neighbors,
                     const LoopBorder& band, const Regions& regions);

}  // namespace cocoon
