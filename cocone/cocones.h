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

#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

struct CoconeOptions {
  // cos(theta): the double cone opens at theta = 3 pi / 8 about the normal.
  double cosine = 0.38268343236508977;
};

// Bit 4 i + j of a cell: the dual edge of facet i meets the cocone of vertex j (j != i). Both cells
// of a facet say the same. Facets with the vertex at infinity have no bits.
struct Cocones {
  IdVector<CellId, std::uint16_t> meets;
  double cosine = 0;  // as in the options: radii are taken for the same cone

  // Does the dual edge of f meet the cocone of vertex j of cell_of(f)? O(1).
  bool meets_cocone_of(FacetId f, int j) const {
    return ((meets[cell_of(f)] >> (4 * index_of(f) + j)) & 1U) != 0;
  }
  // The four bits of facet f, bit j for vertex j of its cell.
  unsigned row(FacetId f) const { return (meets[cell_of(f)] >> (4 * index_of(f))) & 15U; }
};

// Tests all dual edges, segments by their two ends, rays by their origin and direction (exact: see
// double_cone.h). A zero-length edge meets the cocone iff its one point lies in it.
// Complexity: O(cells), parallel. Deterministic: each bit is a function of the facet's two cells.
// Source: Amenta, Choi, Dey & Leekha 2002; Woo & Dey 2005, section 2.1 (cocone).
Cocones intersect_cocones(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                          const CoconeOptions& options = {}, const Execution& execution = {});

// What "radius" of a sample means in the ratio condition.
enum class RadiusMode : std::uint8_t {
  cocone,         // r_p = max |y - p| over the cocone C_p: the definition
  tangent_plane,  // w_p = max |y - p| over V_p and the tangent plane: the cocone opened by zero
};

// The radius of one sample; infinite if V_p is unbounded there. In mode `cocone` the maximum of
// |x(t)| over the parts of dual edges inside the cocone: attained at an end inside it, or where the
// edge crosses the cone, (x.n + t d.n)^2 = C^2 |x + t d|^2. In mode `tangent_plane` over the points
// where dual edges cross x.n = 0; infinite if a hull normal at p makes no acute angle with n_p.
// Complexity: O(cells at p). Independent of the order of cells: edges are taken from the
// lexicographically smaller end.
double cocone_radius(const Triangulation& triangulation, const Dual& dual, const VertexStars& stars,
                     const Poles& poles, const Cocones& cocones, VertexId p, RadiusMode mode);

}  // namespace cocoon
