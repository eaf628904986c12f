// Cocone and Tight Cocone by the papers, on CGAL's triangulation: what a researcher writes who has
// CGAL and no kernel of his own. Shares no code with the stages.
#pragma once

#include <array>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "ref/cgal_cocone.h"

namespace cocoon::ref {

struct CgalSurface {
  std::vector<std::array<PointId, 3>> triangles;
  double delaunay_seconds = 0;  // processor time of the triangulation alone
};

// The open surface of a cloud: the sheet that walks over the candidates meet, after pruning. Not
// oriented. Precondition: points are all different, not coplanar.
CgalSurface cgal_open_surface(Points points, const CgalCoconeOptions& options);

// The watertight surface, oriented outward, by marking and peeling; none if no sample is interior.
// Precondition as above. Both are functions of the set of points, but for ties within rounding.
// Complexity of both: as CGAL's triangulation, and the sum of star sizes.
// Source: Amenta, Choi, Dey & Leekha 2002; Dey & Giesen 2001; Dey & Goswami 2003; the orders of
// work are ours (README.md).
CgalSurface cgal_tight_surface(Points points, const CgalCoconeOptions& options = {});

}  // namespace cocoon::ref
