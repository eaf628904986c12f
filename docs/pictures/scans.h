// The scans whose sections by the plane z = 0 the pictures of docs/cocone.md show.
#pragma once

#include <vector>

#include "docs/pictures/svg_canvas.h"
#include "geom/point.h"

namespace cocoon::pictures {

// A ball with a finger, a lobe and a dent, in the plane z = 0. Complexity: O(1), 720 points.
std::vector<Planar> outline_of_body();

// Samples of that body, no closer than 0.8 spacings to each other, but not of its lower side; some
// lie on the outline, about a spacing apart, so that the section shows them. Deterministic.
std::vector<Point> scan_of_body();

// A bar with a triangular section along the z axis, its edge at the origin, with noise of 0.15
// spacings; some samples lie in the plane z = 0. Deterministic.
std::vector<Point> scan_of_edge();

}  // namespace cocoon::pictures
