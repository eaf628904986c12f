// Cocones: which dual edges meet the cocone of which samples.
//
//   C_p = { y in V_p : the acute angle between the lines of (y - p) and n_p is >= theta }
//
// The cocone is what is left of the Voronoi cell when the double cone about the normal is taken
// away: a thickened tangent disk. A facet whose dual edge meets the cocones of its three corners
// is a cocone triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/poles.h"
#include "cocone/samples/cone_sides.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct CoconeOptions {
  // cos(theta): the double cone opens at theta = 3 pi / 8 about the normal.
  double cosine = 0.38268343236508977;
};

// The facets whose dual edge meets the cocone of at least one of their corners: on the samples of a
// surface few of all, about as many as the surface has triangles.
struct Cocones {
  std::vector<FacetId> facets;        // finite, canonical ids, ascending
  OverwriteVector<FacetId> mirrors;   // of each: as the cell behind it numbers it
  OverwriteVector<Triangle> corners;  // of each: Triangulation::facet_vertices
  std::vector<std::uint8_t> rows;  // of each: bit j = it meets the cocone of vertex j of its cell
  double cosine = 0;               // as in the options: radii are taken for the same cone

  // The bits of facet k in the order of its corners: bit i = it meets the cocone of corners[k][i].
  unsigned met_corners(std::size_t k) const {
    const int* const places = facet_corners[index_of(facets[k])];
    const unsigned row = rows[k];
    return (row >> places[0] & 1U) | (row >> places[1] & 1U) << 1 | (row >> places[2] & 1U) << 2;
  }
};

// Tests all dual edges, segments by their two ends, rays by their origin and direction: no case is
// missed (double_cone.h), but the side of an end is told in floating point. A zero-length edge
// meets the cocone iff its one point lies in it. Errors: InputError for parts of another
// triangulation, by their sizes, and for options out of range (inputs/stage_inputs.h). Complexity:
// O(cells), parallel. Deterministic: each bit is a function of the facet's two cells. Source:
// Amenta, Choi, Dey & Leekha 2002; Woo & Dey 2005, section 2.1 (cocone).
Cocones intersect_cocones(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                          const CoconeOptions& options = {}, const Execution& execution = {});

// Overload for callers that already have the sides of the Voronoi vertices (poles_and_sides()
// finds them on its way).
Cocones intersect_cocones(const Triangulation& triangulation, ConeSides sides,
                          const Execution& execution = {});

}  // namespace cocoon
