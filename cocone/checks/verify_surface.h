// Does a surface keep what its stage promises? Judged from the triangulation and the mesh alone,
// with exact decisions only: nothing that built them is trusted.
//
// The triangulation is certified to be THE Delaunay triangulation of its points (check_delaunay).
// That every triangle is a facet of it then says all about geometry: facets of a triangulation meet
// in common edges and vertices only, so the surface does not cross itself. The rest is counting.
#pragma once

#include <cstddef>
#include <string>

#include "cocone/surface_mesh.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

struct SurfaceVerification {
  bool done = false;
  std::size_t cells = 0;              // finite cells of the triangulation
  std::size_t triangles = 0;          // of the surface
  DelaunayReport delaunay;            // violations of the triangulation
  std::size_t strange_triangles = 0;  // that are no facet of the triangulation
  std::size_t moved_vertices = 0;     // without the bits of the input point they stand for, or with
                                      // a vertex of the triangulation at another place
  std::size_t repeated_corners = 0;   // triangles that name a vertex twice
  std::size_t repeated_triangles = 0;  // with the same three vertices as an earlier one
  std::size_t unbalanced_edges = 0;    // a closed surface only: edges that are not run through
                                       // equally often in both directions
  std::size_t turned_triangles = 0;    // a closed surface only, if all else is right: normals that
                                       // point into the body
  // The first thing that is wrong, one line; empty if all is right.
  std::string failure;

  bool ok() const { return done && failure.empty(); }
};

struct VerifyOptions {
  bool closed = true;  // a tight surface: every edge is balanced
  // What coordinates were multiplied by before they were triangulated (geom/working_scale.h).
  double scale = 1;
};

// Verifies the surface of `points` that `triangulation` gave. Everything may be wrong with either,
// but ids that are out of range in point_of_vertex and triangulation_vertex are the caller's.
// Errors: InputError unless these have an entry for each vertex.
// Complexity: O(cells + triangles log triangles); measured figures: docs/stages/verify_surface.md.
// Deterministic for any thread count. Progress: "verify/..."; Cancelled. Source: ours.
SurfaceVerification verify_surface(const Triangulation& triangulation, const SurfaceMesh& surface,
                                   Points points, const VerifyOptions& options = {},
                                   const Execution& execution = {});

}  // namespace cocoon
