// How far the cocone of each sample reaches.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/cocones.h"
#include "cocone/facet_set.h"
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
// `cocones` + hull + vertices), parallel over facets. A maximum, each edge taken from the end that
// is nearer or lexicographically smaller: independent of order. Source: Dey & Giesen 2001 (radius);
// the tangent plane after the practice of the Cocone programs.
IdVector<VertexId, double> cocone_radii(const Triangulation& triangulation, const Dual& dual,
                                        const Poles& poles, const Cocones& cocones, RadiusMode mode,
                                        const Execution& execution = {});

// The same of some samples, those with a flag; the others get 0. Looks at no Voronoi vertices but
// those of facets that meet the cocone of one of them.
IdVector<VertexId, double> cocone_radii(const Triangulation& triangulation, const Dual& dual,
                                        const Poles& poles, const Cocones& cocones, RadiusMode mode,
                                        const VertexSet& samples, const Execution& execution = {});

// Hull samples whose radius in mode `tangent_plane` is infinite by their hull normals, each once or
// more. Complexity: O(hull).
std::vector<VertexId> unbounded_in_plane(const Triangulation& triangulation, const Dual& dual,
                                         const Poles& poles);

}  // namespace cocoon
