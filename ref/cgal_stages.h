// What each stage of the plain Tight Cocone gives (cgal_surface.h), one after the other: for tests
// that ask where two ways part.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "ref/cgal_cocone.h"
#include "ref/marking_rounds.h"

namespace cocoon::ref {

struct StagesCell {
  std::array<PointId, 4> corners;  // ids ascending; none is the vertex at infinity, last
  Side marked;                     // after the marking
  Side peeled;                     // after the peel
  bool reached;                    // by the peel
  PointId stop;                    // opposite to the facet with the smallest circle; none: unknown
};

struct TightStages {
  using Triangles = std::vector<std::array<PointId, 3>>;  // ids ascending in each, then sorted
  using Flags = IdVector<PointId, std::uint8_t>;

  IdVector<PointId, Vec3> normals;    // of the poles, unit
  IdVector<PointId, double> heights;  // distances of the negative poles
  Flags boundary;
  Triangles candidates;
  Flags umbrella;
  Triangles left;     // by the pruning
  Triangles surface;  // the sheet
  Flags good;
  Flags visited;                  // good vertices that the marking has come to, before the peel
  std::vector<StagesCell> cells;  // sorted by their corners
  Triangles triangles;            // the watertight surface
  std::size_t ties = 0;           // choices taken over, see below
};

// Which Voronoi vertex is the farthest, and which facet of a cell the smallest, may be a tie within
// rounding (1e-12 of the length). There the choice of `at_ties` is taken, if it is given: if all is
// equal then, ties explain all that was not. Precondition and complexity as cgal_tight_surface.
TightStages cgal_stages(Points points, const CgalCoconeOptions& options = {},
                        const TightStages* at_ties = nullptr);

}  // namespace cocoon::ref
