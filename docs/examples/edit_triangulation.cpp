// A triangulation that changes: take one over, move some of its points, ask questions, freeze it,
// and find that it is the one that a fresh build gives.
#include <cstdio>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/point_queries.h"

int main() {
  std::vector<cocoon::Point> lattice;
  for (int i = 0; i < 1000; ++i) {
    lattice.push_back({1.0 * (i % 10), 1.0 * (i / 10 % 10), 1.0 * (i / 100)});
  }
  cocoon::DynamicDelaunay dynamic(cocoon::delaunay(lattice).triangulation);

  // The vertices in a corner of the lattice, and where they go.
  std::vector<cocoon::VertexId> corner;
  std::vector<cocoon::Point> moved;
  for (const cocoon::VertexId v : cocoon::id_range<cocoon::VertexId>(dynamic.num_vertex_slots())) {
    const cocoon::Point p = dynamic.point(v);
    if (p.x + p.y + p.z > 4) continue;
    corner.push_back(v);
    moved.push_back(p + cocoon::Vec3{0.1, 0.2, 0.3});
  }
  const cocoon::DelaunayChange change = dynamic.replace(corner, moved);
  std::printf("%zu points moved: %zu cells gone, %zu new, in %zu hole(s)\n", moved.size(),
              change.deleted.size(), change.created.size(), change.removal.holes);

  // Questions need no freezing.
  const cocoon::VertexId nearest = cocoon::nearest_vertex(dynamic.view(), {0.1, 0.2, 0.25});
  const bool found = dynamic.point(nearest) == cocoon::Point{0.1, 0.2, 0.3};

  // A value for the stages, equal to a fresh build of the same points.
  const cocoon::Triangulation frozen = canonical_order(dynamic.freeze().triangulation);
  const cocoon::Triangulation fresh =
      canonical_order(cocoon::delaunay(frozen.points().span()).triangulation);
  return found && frozen.cell_records() == fresh.cell_records() ? 0 : 1;
}
