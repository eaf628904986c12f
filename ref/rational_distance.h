// The distance of a point from a triangle in rational numbers: a slow twin of
// geom/triangle_projection that rounds once, at the end.
#pragma once

#include "geom/point.h"
#include "geom/triangle_projection.h"

namespace cocoon::ref {

// Squared distance of p from the closed triangle, which may be a segment or a point; infinite or 0
// beyond the range of double. Precondition: finite coordinates.
double squared_distance_to_triangle(const Point& p, const TrianglePoints& triangle);

}  // namespace cocoon::ref
