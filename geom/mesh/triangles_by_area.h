// Choosing triangles of a mesh in proportion to their areas.
#pragma once

#include <vector>

#include "geom/random/random.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// In squares of the coordinates' unit. Precondition: the triangle's vertices are there. O(1).
double area_of(const TriangleMesh& mesh, TriangleId triangle);

// The triangles side by side, in their order, as stretches of a line: each as long as its area.
class TrianglesByArea {
 public:
  // Complexity: O(t).
  explicit TrianglesByArea(const TriangleMesh& mesh);

  double area() const { return up_to_.empty() ? 0 : up_to_.back(); }
  // The triangle at that place of the line. Precondition: 0 <= place < area(). O(log t).
  TriangleId at(double place) const;

 private:
  std::vector<double> up_to_;  // the sum of areas up to the end of each triangle
};

// Uniform in the triangle. Takes two numbers of `random`. O(1).
Point random_point_in(const TriangleMesh& mesh, TriangleId triangle, Random& random);

}  // namespace cocoon
