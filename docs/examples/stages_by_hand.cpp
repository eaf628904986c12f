// Cocone stage by stage, in the order of Woo & Dey 2005, section 2. reconstruct_cocone does the
// same in one call; here any line can be replaced by one of your own.
#include <cstdio>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/candidate_triangles.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/surface_mesh.h"
#include "delaunay/delaunay.h"
#include "delaunay/voronoi_dual.h"
#include "docs/examples/bump.h"

int main() {
  const std::vector<cocoon::Point> ball = cap(1000, 4, 0);

  // Cells, and the Voronoi vertices dual to them.
  const cocoon::Triangulation cells = cocoon::delaunay(ball).triangulation;
  const cocoon::Dual dual = cocoon::voronoi_dual(cells);

  // 2.1: poles estimate normals; cocones are what the Voronoi cells have around the tangent plane.
  const cocoon::Poles poles = cocoon::compute_poles(cells, dual);
  const cocoon::Cocones cocones = cocoon::intersect_cocones(cells, dual, poles);

  // 3.2: which samples lie where the surface ends. On a ball, none.
  const cocoon::BoundarySamples boundary = cocoon::boundary_samples(cells, dual, poles, cocones);

  // 2.2: triangles whose dual edges meet the cocones of their corners, without those at sharp
  // edges; of what is left, the outside of a manifold.
  const cocoon::FacetSet candidates =
      cocoon::candidate_triangles(cells, cocones, boundary.boundary);
  const cocoon::PrunedCandidates pruned = cocoon::prune_sharp_edges(cells, candidates);
  const cocoon::ManifoldSurface surface =
      cocoon::extract_manifold(cells, pruned.left, pruned.umbrella);
  const cocoon::TriangleMesh mesh = cocoon::surface_of(cells, surface.halves).mesh;

  std::printf("%zu cells, %zu boundary samples, %zu candidates, %zu triangles\n",
              cells.num_finite_cells(), boundary.count, pruned.candidates, mesh.triangles.size());
  return mesh.triangles.size() == 2 * 1000 - 4 ? 0 : 1;
}
