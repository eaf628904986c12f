// Ten lines of somebody else's program: a tetrahedron's four points become a closed surface.
#include <cstdio>
#include <vector>

#include "delaunay/delaunay.h"

int main() {
  const std::vector<cocoon::Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const cocoon::DelaunayResult result = cocoon::delaunay(points);
  std::printf("%zu tetrahedra\n", result.triangulation.num_finite_cells());
  return result.triangulation.num_finite_cells() == 1 ? 0 : 1;
}
