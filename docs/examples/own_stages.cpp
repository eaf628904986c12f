// Stages of one's own among those of the library: normals from neighbors instead of poles, and a
// filter of candidates that Cocone does not have. The rest of Tight Cocone takes what it is given.
// What came of it is written for ParaView: heights and labels with the tetrahedra, normals' errors
// with the surface.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/candidate_triangles.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/surface_mesh.h"
#include "delaunay/delaunay.h"
#include "delaunay/point_queries.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "docs/examples/bump.h"
#include "geom/angles.h"
#include "geom/mesh_check.h"
#include "io/mesh_file.h"
#include "io/tetrahedra_file.h"

namespace {

using namespace cocoon;

// The mean of the normals at v and its neighbors, weighted with what their heights say they are
// worth. The heights stay those of the poles.
Poles smoothed(const Triangulation& cells, const Poles& poles) {
  const VertexStars stars = vertex_stars(cells);
  Poles mine = poles;
  for (const VertexId v : cells.vertices()) {
    Vec3 sum = poles.heights[v] * poles.normals[v];
    for (const VertexId w : neighbors_of_vertex(cells, v, stars.star(v).front())) {
      const double agreement = dot(poles.normals[w], poles.normals[v]);  // their signs are free
      sum = sum + agreement * poles.heights[w] * poles.normals[w];
    }
    if (squared_norm(sum) > 0) mine.normals[v] = unit(sum);
  }
  return mine;
}

// Takes out the candidates with an edge longer than `limit`.
std::size_t drop_long(const Triangulation& cells, double limit, FacetSet& candidates) {
  std::vector<FacetId> dropped;
  candidates.for_each(cells, [&](FacetId f) {
    const auto [a, b, c] = cells.facet_vertices(f);
    const Point& p = cells.point(a);
    const Point& q = cells.point(b);
    const Point& r = cells.point(c);
    const double longest = std::max({distance(p, q), distance(q, r), distance(r, p)});
    if (longest > limit) dropped.push_back(f);
  });
  for (const FacetId f : dropped) candidates.erase(cells, f);
  return dropped.size();
}

}  // namespace

int main() {
  const std::vector<Point> ball = cap(1000, 1.8755, 0);  // a ball that was not scanned from below
  const Triangulation cells = delaunay(ball).triangulation;
  const Dual dual = voronoi_dual(cells);
  const Poles poles = smoothed(cells, compute_poles(cells, dual));

  const Cocones cocones = intersect_cocones(cells, dual, poles);
  const BoundarySamples boundary = boundary_samples(cells, dual, poles, cocones);
  FacetSet candidates = candidate_triangles(cells, cocones, boundary.boundary);
  const std::size_t dropped = drop_long(cells, 0.25, candidates);
  const PrunedCandidates pruned = prune_sharp_edges(cells, std::move(candidates));
  const ManifoldSurface surface = extract_manifold(cells, pruned.left, pruned.umbrella);
  const CellMarks marks = peel_cells(cells, surface.triangles.set,
                                     mark_cells(cells, surface.triangles, boundary.boundary));
  const SurfaceMesh closed = surface_between(cells, marks);
  std::printf("%zu boundary samples, %zu long candidates dropped, %zu pruned, %zu triangles\n",
              boundary.count, dropped, pruned.pruned, closed.mesh.triangles.size());

  // Of cells: 1 = inside. Of vertices: heights of poles. Of the surface: how far the normals are
  // from the true ones, which on the unit ball are the points.
  std::vector<double> inside;
  for (const CellId c : cells.finite_cells()) inside.push_back(marks.reached[c] == 0 ? 1 : 0);
  std::vector<double> degrees;
  std::vector<std::uint8_t> flags;
  for (const VertexId v : closed.triangulation_vertex) {
    const double cosine = std::abs(dot(poles.normals[v], unit(cells.point(v))));
    degrees.push_back(std::acos(std::min(1.0, cosine)) * degrees_per_radian);
    flags.push_back(boundary.boundary[v]);
  }
  VertexProperties properties;
  properties.rows = closed.mesh.points.size();
  properties.columns = {property_of("degrees", degrees), property_of("boundary", flags)};

  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  write_mesh(folder / "own_stages.ply", closed.mesh, properties);
  write_tetrahedra(folder / "own_stages.vtu", cells,
                   {{{"height", poles.heights.span()}}, {{"inside", inside}}});
  std::printf("written to %s\n", folder.c_str());
  return dropped > 0 && mesh_check(closed.mesh).is_closed_manifold() ? 0 : 1;
}
