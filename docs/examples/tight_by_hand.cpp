// Tight Cocone stage by stage, in the order of Woo & Dey 2005, section 2.2: a ball that was not
// scanned from below gets a closed surface. reconstruct_tight does the same in one call.
#include <cstdio>
#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/candidate_triangles.h"
#include "cocone/clean_up_cells.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/reconstruct.h"
#include "cocone/surface_mesh.h"
#include "delaunay/delaunay.h"
#include "delaunay/voronoi_dual.h"
#include "docs/examples/bump.h"
#include "geom/mesh_check.h"

int main() {
  const std::vector<cocoon::Point> ball = cap(1000, 1.8755, 0);

  // The open surface, as in stages_by_hand.cpp.
  const cocoon::Triangulation cells = cocoon::delaunay(ball).triangulation;
  const cocoon::Dual dual = cocoon::voronoi_dual(cells);
  const cocoon::Poles poles = cocoon::compute_poles(cells, dual);
  const cocoon::Cocones cocones = cocoon::intersect_cocones(cells, dual, poles);
  const cocoon::BoundarySamples boundary = cocoon::boundary_samples(cells, dual, poles, cocones);
  const cocoon::PrunedCandidates pruned = cocoon::prune_sharp_edges(
      cells, cocoon::candidate_triangles(cells, cocones, boundary.boundary));
  const cocoon::ManifoldSurface surface =
      cocoon::extract_manifold(cells, pruned.left, pruned.umbrella);
  const cocoon::MeshReport open =
      cocoon::mesh_check(cocoon::surface_of(cells, surface.halves).mesh);

  // Marking: from infinity over the surface, good vertices tell which cells lie outside. Peeling:
  // what can be reached from infinity goes, through cells that are outside or have no good vertex,
  // but not through the smallest facets of these. The rest is a body, and its boundary is closed
  // whatever the samples are.
  cocoon::CellMarks marks = cocoon::mark_cells(cells, surface.triangles, boundary.boundary);
  marks = cocoon::peel_cells(cells, surface.triangles.set, std::move(marks));

  // Where no good vertex tells, the clean-up labels anew (ours; mode paper leaves it out).
  const cocoon::CleanUpCounters clean_up = cocoon::clean_up_cells(cells, poles, marks);
  const cocoon::TriangleMesh mesh = cocoon::surface_between(cells, marks).mesh;

  const cocoon::MeshReport closed = cocoon::mesh_check(mesh);
  std::printf("open: %zu triangles, %zu boundary edges; closed: %zu triangles, %zu\n",
              open.triangles, open.open_edges, closed.triangles, closed.open_edges);
  std::printf(
      "%zu of %zu vertices are good, %zu cells have none, %zu changed sides after the peel\n",
      marks.good_vertices, cells.num_vertices(), marks.poor_cells, clean_up.changed_cells);
  const bool as_in_one_call = mesh == cocoon::reconstruct_tight(ball).mesh;
  return open.open_edges > 0 && closed.is_closed_manifold() && as_in_one_call ? 0 : 1;
}
