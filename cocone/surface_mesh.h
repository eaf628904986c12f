// From facets of the triangulation to a triangle mesh of its own.
#pragma once

#include <span>

#include "cocone/cell_marks.h"
#include "cocone/facets/linked_facets.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct SurfaceMesh {
  // Only vertices that a triangle uses, in the user's input order; triangles in canonical order
  // (geom/triangle_mesh.h), counterclockwise seen from outside.
  TriangleMesh mesh;
  // Per mesh vertex: the input point it stands for, and the vertex of the triangulation.
  IdVector<VertexId, PointId> point_of_vertex;
  IdVector<VertexId, VertexId> triangulation_vertex;
};

// The mesh of the facets seen from `halves` (extract_manifold.h): the normals of its triangles
// point into cell_of(half). Complexity: O(points + triangles), parallel. Deterministic: a
// function of the set of facets.
SurfaceMesh surface_of(const Triangulation& triangulation, std::span<const FacetId> halves,
                       const Execution& execution = {});

// Overload for callers that have the triangles with their corners: saves a look at the cell of
// each. `halves`: of each triangle, at its place.
SurfaceMesh surface_of(const Triangulation& triangulation, LinkedFacets triangles,
                       std::span<const FacetId> halves, const Execution& execution = {});

// The boundary of the body: all facets between a cell reached by the peel (1) and one not reached,
// with normals away from the body. Every directed edge is balanced: as many triangles run through
// an edge in one direction as in the other. Empty if everything was peeled. Precondition: infinite
// cells are reached. Errors: InputError unless there is a flag for each cell, as after the peel.
// Complexity: O(cells) and as above, parallel. Source: Dey & Goswami 2003 (Tight Cocone, peeling).
SurfaceMesh surface_between(const Triangulation& triangulation,
                            const IdVector<CellId, std::uint8_t>& reached,
                            const Execution& execution = {});
inline SurfaceMesh surface_between(const Triangulation& triangulation, const CellMarks& marks,
                                   const Execution& execution = {}) {
  return surface_between(triangulation, marks.reached, execution);
}

}  // namespace cocoon
