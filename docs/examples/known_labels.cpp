// A mesh tells which cells are inside far from where its samples have changed. Here a few samples
// of a ball go; the triangles at all others tell.
#include "cocone/known_labels.h"

#include <cstdio>
#include <vector>

#include "cocone/reconstruct.h"
#include "delaunay/delaunay.h"
#include "docs/examples/bump.h"

int main() {
  const std::vector<cocoon::Point> ball = cap(1000, 3.1, 0);
  const cocoon::TriangleMesh old = cocoon::reconstruct_tight(ball).mesh;

  // Samples on one side go. What is left of the old triangles names samples by their new positions.
  std::vector<cocoon::Point> rest;
  cocoon::IdVector<cocoon::VertexId, cocoon::PointId> now(old.points.size());
  for (const cocoon::VertexId v : old.points.ids()) {
    if (old.points[v].x > 0.95) continue;
    now[v] = cocoon::PointId(rest.size());
    rest.push_back(old.points[v]);
  }
  std::vector<cocoon::KnownTriangle> triangles;
  for (const auto& [a, b, c] : old.triangles) {
    if (now[a].is_none() || now[b].is_none() || now[c].is_none()) continue;
    triangles.push_back({now[a], now[b], now[c]});
  }

  const cocoon::Triangulation cells = cocoon::delaunay(rest).triangulation;
  const cocoon::KnownLabels known =
      cocoon::known_labels(cells, triangles, cocoon::FacetSet(cells.num_cells()));
  std::size_t inside = 0;
  for (const cocoon::CellLabel label : known.labels) inside += label == cocoon::CellLabel::in;
  std::printf("%zu of %zu cells are known, %zu of them inside\n", known.cells,
              cells.num_finite_cells(), inside);

  const cocoon::ReconstructResult updated = cocoon::reconstruct_tight_with_labels(
      rest, [&](const cocoon::Triangulation& of_rest, const cocoon::FacetSet& surface,
                const cocoon::Execution& execution) {
        return cocoon::known_labels(of_rest, triangles, surface, execution);
      });
  std::printf("%zu triangles before, %zu after\n", old.triangles.size(),
              updated.mesh.triangles.size());
  return known.cells > cells.num_finite_cells() / 2 && updated.mesh.points.size() == rest.size()
             ? 0
             : 1;
}
