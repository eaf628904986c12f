// CGAL's surface reconstructions from points alone, as its manual shows them.
#pragma once

#include "bench/stopwatch.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::rivals {

struct TimedSurface {
  TriangleMesh mesh;  // on the points given, in their order
  bench::Elapsed elapsed;
};

// advancing_front_surface_reconstruction with its defaults.
// Source: Cohen-Steiner & Da, A greedy Delaunay-based surface reconstruction algorithm (2004).
TimedSurface cgal_advancing_front(Points points);

// Scale_space_surface_reconstruction_3: four steps to a coarser scale (weighted PCA), then its
// advancing front mesher with its defaults; triangles are drawn on the points given.
// Source: Digne, Morel, Souzani & Lartigue, Scale space meshing of raw data point sets (2011).
TimedSurface cgal_scale_space(Points points);

}  // namespace cocoon::rivals
