// Coordinates of extreme size, brought where floating point has room on both sides.
#pragma once

#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// The power of two that brings the largest |coordinate| near 1, if it lies outside of
// [2^-100, 2^100]; else 1. Inside these bounds the products of the stages stay in the range of
// double and the filters of the predicates work. Scaling by it changes no decision that is exact,
// as long as it rounds nothing away (scales_exactly).
// Precondition: finite coordinates. Complexity: O(n).
double working_scale(Points points, const Execution& execution = {});

// One scale for two sets of points whose distances from each other are asked for, so that squares
// of areas stay in the range of double: the larger set decides. It is brought not to 1 but to 2^200
// if it is too large, so that squares of what is much smaller do not vanish. Precondition and
// complexity: as above.
double common_scale(Points a, Points b);

// Throws InputError, which names the point that is farthest out, if the coordinates of most of the
// points, those at the origin left aside, are smaller than 2^-200 times the largest one: then no
// scale holds both the squares of areas among these and those of the others. Of points that are not
// finite it says nothing: that is for who needs them to be. Complexity: O(n).
void require_comparable_sizes(Points points, const Execution& execution = {});

// True iff every coordinate times `scale`, a power of two, is representable: nothing is lost to
// underflow. Complexity: O(n).
bool scales_exactly(Points points, double scale);

// Copies whose coordinates are multiplied by the factor. Complexity: O(n).
std::vector<Point> scaled(Points points, double factor);
TriangleMesh scaled(TriangleMesh mesh, double factor);

}  // namespace cocoon
