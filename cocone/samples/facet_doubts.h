// What the facets alone tell of the conditions of Boundary (boundary_samples.h), without a look at
// Voronoi vertices: for nearly all samples of a surface that is enough.
//
// The dual edge of a facet with circumcenter c and normal N lies on the line c + s N. With
// a = c - p for a corner p, and n = n_p, it meets the tangent plane of p where
//
//   (a + s N) . n = 0,  so  |y - p|^2 = R^2 + (a . n)^2 N^2 / (N . n)^2,
//
// R the circumradius, since a is orthogonal to N. In the cocone, |(y - p) . n| <= C |y - p|, are
// only points with
//
//   |s| |N . n| <= C |y - p| + |a . n|,  so  |s N| <= (C R + |a . n|) / (|N . n| / |N| - C)
//
// by |y - p| <= R + |s N|, if the line is steeper than the cone. Where such a bound is within rho
// h_p the facet cannot make the ratio condition fail.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/boundary_options.h"
#include "cocone/cocones.h"
#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Of one facet of `cocones`. Bit i: its dual edge meets the cocone of corner i, and the ratio
// condition of that corner is not certain to hold as far as this facet goes. Bit 3 + i: the normals
// of corners i and i + 1 (modulo 3) do not agree, whatever cocones it meets.
using FacetDoubts = std::uint8_t;
inline constexpr FacetDoubts ratio_doubts = 0b000'111;
inline constexpr FacetDoubts normals_disagree = 0b111'000;

// Of each facet of `cocones`. The bounds have room for all roundings where the facet is neither
// thin (sine of the angle at its first corner below 2^-10) nor steep to the tangent plane;
// elsewhere there is doubt.
// The normals are compared as normals_agree() does, without doubt.
// Complexity: O(facets of `cocones`), parallel, in SIMD lanes. Deterministic: a function of the
// points and poles of the facet's corners; corners are taken in lexicographic order.
// Source: ours; conditions of Dey & Giesen 2001.
std::vector<FacetDoubts> facet_doubts(const Triangulation& triangulation, const Poles& poles,
                                      const Cocones& cocones, const BoundaryOptions& options,
                                      const Execution& execution = {});

}  // namespace cocoon
