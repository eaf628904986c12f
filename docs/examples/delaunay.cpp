// A Delaunay triangulation, its certificate, and its dual: cells, the points at their corners, and
// the farthest Voronoi vertex around each vertex, which is its pole.
#include "delaunay/delaunay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "delaunay/check_delaunay.h"
#include "delaunay/circulate.h"
#include "delaunay/voronoi_dual.h"

int main() {
  std::vector<cocoon::Point> points;
  for (int i = 0; i < 200; ++i) {
    points.push_back({std::sin(1.0 * i), std::sin(2.0 * i + 1), std::sin(3.0 * i + 2)});
  }
  const cocoon::Triangulation triangulation = cocoon::delaunay(points).triangulation;
  const cocoon::DelaunayReport report = cocoon::check_delaunay(triangulation);

  // Vertices are numbered by the triangulation; each knows its point among those given.
  double volume = 0;
  for (const cocoon::CellId c : triangulation.finite_cells()) {
    const auto corner = [&](std::size_t i) {
      const cocoon::VertexId v = triangulation.cell(c).vertices[i];
      return points[triangulation.point_of_vertex(v).index()];
    };
    const cocoon::Vec3 side = corner(3) - corner(0);
    volume += dot(cross(corner(1) - corner(0), corner(2) - corner(0)), side) / 6;
  }

  const cocoon::Dual dual = cocoon::voronoi_dual(triangulation);
  const cocoon::VertexStars stars = cocoon::vertex_stars(triangulation);
  std::size_t bounded = 0;
  double farthest = 0;
  for (const cocoon::VertexId v : triangulation.vertices()) {
    if (is_hull_vertex(triangulation, stars, v)) continue;  // its Voronoi cell has no end
    ++bounded;
    for (const cocoon::CellId c : stars.star(v)) {
      farthest = std::max(farthest, distance(dual.centers[c], triangulation.point(v)));
    }
  }
  std::printf("%zu cells of volume %.4f; %zu bounded Voronoi cells, the farthest pole %.2f away\n",
              triangulation.num_finite_cells(), volume, bounded, farthest);
  return report.ok() && volume > 0 && volume < 8 && bounded > 0 ? 0 : 1;
}
