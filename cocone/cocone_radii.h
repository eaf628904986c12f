// How far the cocone of each sample reaches.
#pragma once

#include <cstdint>

#include "cocone/cocones.h"
#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// What "radius" of a sample means in the ratio condition.
enum class RadiusMode : std::uint8_t {
  cocone,         // r_p = max |y - p| over the cocone C_p: the definition
  tangent_plane,  // w_p = max |y - p| over V_p and the tangent plane: the cocone opened by zero
};

// The radius of every sample, in units of the coordinates; infinite if V_p is unbounded there, 0 if
// no dual edge meets the cocone. In mode `cocone` the maximum of |x(t)| over the parts of dual
// edges inside the cocone: attained at an end inside it, or where the edge crosses the cone, (x.n +
// t d.n)^2 = C^2 |x + t d|^2. In mode `tangent_plane` over the points where dual edges cross x.n =
// 0; infinite if a hull normal at p makes no acute angle with n_p. Complexity: O(facets of
// `cocones` + hull + vertices), parallel over facets. A maximum, each edge taken from its
// lexicographically smaller end: independent of order. Source: Dey & Giesen 2001 (radius); the
// tangent plane after the practice of the Cocone programs.
IdVector<VertexId, double> cocone_radii(const Triangulation& triangulation, const Dual& dual,
                                        const Poles& poles, const Cocones& cocones, RadiusMode mode,
                                        const Execution& execution = {});

}  // namespace cocoon
