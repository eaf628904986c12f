// Solids given by a function that is negative inside and positive outside: the material that the
// sample models are carved from.
#pragma once

#include <functional>

#include "geom/box.h"
#include "geom/point.h"

namespace cocoon {

// Signed distance to the surface, or something close to it near the surface: continuous, with a
// gradient of length about 1.
using ImplicitFunction = std::function<double(const Point&)>;

struct ImplicitSolid {
  ImplicitFunction value;
  Box box;  // contains the solid with some room around it
};

// Distance to the box |x| <= half.x, ... with edges and corners rounded by `radius`.
double rounded_box(const Point& p, const Vec3& half, double radius);

// Distance to the solid that stands on a plane figure: `figure` is the signed distance to the
// figure below p, `height` the signed distance to the slab between the two end planes; edges
// between side and ends are rounded by `radius`.
double rounded_extrusion(double figure, double height, double radius);

// Union of two solids with a fillet where they meet. It is exactly min(a, b) where |a - b| >=
// width: outside a band of that width the smaller solid leaves the larger one's surface unchanged.
// Source: the quadratic polynomial smooth minimum (Quilez, Smooth minimum).
double filleted_union(double a, double b, double width);

// What a and b have in common, and a without b: filleted_union() of the complements, so that what
// is said there about the band holds. The edge that the second solid leaves is rounded.
double filleted_intersection(double a, double b, double width);
double filleted_difference(double a, double b, double width);

// Distance to the hull of two balls about a and b (a capsule, if of equal radii). Precondition:
// neither ball contains the other.
double round_cone(const Point& p, const Point& a, double radius_a, const Point& b, double radius_b);

// Close to the distance to the ellipsoid |p / half| <= 1 near its surface: the function is zero
// there and has a gradient of length 1.
double ellipsoid(const Point& p, const Vec3& half);

// The gradient of f at p by central differences with the given step. Complexity: six calls of f.
Vec3 gradient(const ImplicitFunction& f, const Point& p, double step);

// Moves p along the gradient to the surface f = 0 by Newton's method, until |f| <= 1e-9 step.
// Precondition: p is near the
// surface, closer than its curvature radius. Complexity: at most 8 steps of 7 calls.
Point project_to_surface(const ImplicitFunction& f, const Point& p, double step);

}  // namespace cocoon
