// Poles: the farthest Voronoi vertices of each sample, and with them a surface normal for free.
//
//   p not on the hull:  p+ = farthest Voronoi vertex of V_p,        n_p = (p+ - p) / |p+ - p|
//   p on the hull:      p+ at infinity, s = sum of d_f over the hull facets f at p, n_p = s / |s|
//   height:             h_p = max { |c - p| : c Voronoi vertex of V_p, (c - p) . n_p < 0 }, or 0
//
// d_f: unit outward normal of the hull facet f. h_p is the distance to the negative pole p-, an
// estimate of the distance to the medial axis.
#pragma once

#include <cstddef>

#include "cocone/facet_set.h"
#include "cocone/samples/cone_sides.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// They may be of one's own instead (docs/examples/own_stages.cpp): intersect_cocones() reads the
// normals, boundary_samples() all three arrays, of each one element per vertex; clean_up_cells()
// the normals at the hull.
struct Poles {
  IdVector<VertexId, Vec3> normals;    // n_p, unit; which side it points to means nothing
  IdVector<VertexId, double> heights;  // h_p, in units of the coordinates; 0 = no negative pole
  // Hull vertices whose hull normals cancel (|s| < 0.1 k for k facets: the rim of a flat cloud).
  // n_p is then the principal eigenvector of sum d_f d_f^T; they are never interior samples.
  VertexSet degenerate;
  std::size_t hull_vertices = 0;
  std::size_t degenerate_vertices = 0;
};

// The poles of every vertex. Ties between equally far Voronoi vertices go to the lexicographically
// smallest one, hull normals are summed in lexicographic order: the result is a function of the
// point set, not of ids.
// Errors: InputError for parts of another triangulation, by their sizes (inputs/stage_inputs.h).
// Precondition: |coordinate| < 1e75 (the compositions of reconstruct.h see to that). Circumcenters
// may be anything finite. Complexity: O(cells + vertices): two passes over the cells, each a
// maximum per corner, parallel. Source: Amenta, Bern & Kamvysselis 1998; Woo & Dey 2005,
// section 2.1 (poles).
Poles compute_poles(const Triangulation& triangulation, const Dual& dual,
                    const Execution& execution = {});

struct PolesAndSides {
  Poles poles;
  ConeSides sides;
};

// The same, and the sides of all Voronoi vertices to the double cones of this cosine about the
// normals, which the cocones are read off (cocones.h): the second pass has them at hand. The cosine
// must be that of the cocones that are read off. Errors: InputError for one that is out of range.
// Complexity: the same.
PolesAndSides poles_and_sides(const Triangulation& triangulation, const Dual& dual, double cosine,
                              const Execution& execution = {});

struct DualAndPoles {
  Dual dual;  // lean
  Poles poles;
  ConeSides sides;
};

// The same of a triangulation whose dual is not known yet: the first pass makes it on its way.
// Complexity: the same.
DualAndPoles dual_and_poles(const Triangulation& triangulation, double cosine,
                            const Execution& execution = {});

}  // namespace cocoon
