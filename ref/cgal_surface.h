// Cocone and Tight Cocone by the papers, on CGAL's triangulation: what a researcher writes who has
// CGAL and no kernel of his own. Shares no code with the stages.
#pragma once

#include <array>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon::ref {

struct CgalSurfaceOptions {
  double rho = 1 / 1.2;
  double alpha_cosine = 0.86602540378443865;  // 30 degrees
  double theta_cosine = 0.38268343236508977;  // cocone of 22.5 degrees
  bool tangent_plane_radius = true;           // else that of the whole cocone
};

struct CgalSurface {
  std::vector<std::array<PointId, 3>> triangles;
  double delaunay_seconds = 0;  // processor time of the triangulation alone
};

// The open surface of a cloud: the sheet that a walk over the candidates meets, after pruning. Not
// oriented. Precondition: points are all different, not coplanar.
CgalSurface cgal_open_surface(Points points, const CgalSurfaceOptions& options);

// The watertight surface, oriented outward: marking and peeling, without the second pass.
// Precondition as above. Complexity of both: as CGAL's triangulation, and the sum of star sizes.
// Source: Amenta, Choi, Dey & Leekha 2002; Dey & Giesen 2001; Dey & Goswami 2003.
CgalSurface cgal_tight_surface(Points points, const CgalSurfaceOptions& options = {});

}  // namespace cocoon::ref
