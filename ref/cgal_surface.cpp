#include "ref/cgal_surface.h"

#include "ref/cgal_triangulation.h"

namespace cocoon::ref {
namespace {

using namespace on_cgal;

// CGAL numbers the corners of a facet clockwise seen from outside of its cell.
std::array<PointId, 3> ids(const Facet& f) {
  return {PointId(corner(f, 0)->info().id), PointId(corner(f, 2)->info().id),
          PointId(corner(f, 1)->info().id)};
}

}  // namespace

CgalSurface cgal_open_surface(Points points, const CgalCoconeOptions& options) {
  CgalSurface result;
  Delaunay delaunay = triangulation_of(points, &result.delaunay_seconds);
  find_candidates(delaunay, options);
  prune(delaunay);
  walk(delaunay);
  for (const Facet& f : delaunay.finite_facets()) {
    if (is_surface(f)) result.triangles.push_back(ids(f));
  }
  return result;
}

CgalSurface cgal_tight_surface(Points points, const CgalCoconeOptions& options) {
  CgalSurface result;
  Delaunay delaunay = triangulation_of(points, &result.delaunay_seconds);
  if (!find_candidates(delaunay, options)) return result;
  prune(delaunay);
  walk(delaunay);
  mark(delaunay, options);
  peel(delaunay);
  for (const CellHandle c : delaunay.finite_cell_handles()) {
    if (c->info().reached) continue;
    for (int i = 0; i < 4; ++i) {
      if (c->neighbor(i)->info().reached) result.triangles.push_back(ids({c, i}));
    }
  }
  return result;
}

}  // namespace cocoon::ref
