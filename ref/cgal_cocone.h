// Labels and candidates of Cocone by the papers, on CGAL's triangulation, with CGAL's
// circumcenters, of flat cells in rational numbers: written for reading. Shares no code with the
// stages.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon::ref {

struct CgalCoconeOptions {
  double rho = 1 / 1.2;
  double alpha_cosine = 0.86602540378443865;  // 30 degrees
  double theta_cosine = 0.38268343236508977;  // cocone of 22.5 degrees
  bool tangent_plane_radius = true;           // else that of the whole cocone
  // Of cgal_surface.h alone. Ends of folds are poor: two triangles at a dihedral whose cosine is at
  // least this; and boundary samples, where it is above the other.
  double fold_cosine = 0.9;  // 25.8 degrees
  double crease_cosine = 0;  // 90 degrees
};

struct CgalCocone {
  IdVector<PointId, std::uint8_t> boundary;        // 1 = boundary sample
  std::vector<std::array<PointId, 3>> candidates;  // ids ascending in each, then sorted
};

// Precondition: points are all different and not coplanar. Complexity: as CGAL's triangulation,
// and the sum of star sizes.
// Source: Amenta, Choi, Dey & Leekha 2002; Dey & Giesen 2001; Woo & Dey 2005, sections 2 and 3.2.
CgalCocone cgal_cocone(Points points, const CgalCoconeOptions& options = {});

}  // namespace cocoon::ref
