// A mesh as checks and measures of all its neighborhoods want it: a copy numbered so that what is
// near in space is near in memory, with its edges and vertices linked.
//
// Use this to look at all edges and vertices of a large mesh. For who keeps the numbers of the
// mesh, or looks at few places, see halfedges.h and triangles_at_vertices.h.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/mesh/halfedges.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct LinkedMesh {
  // Copies, and what the originals are called; ids below are those of the copies.
  IdVector<VertexId, Point> points;  // grouped along a space-filling curve
  IdVector<VertexId, VertexId> vertex_of;
  // Those with three different vertices, by their smallest one.
  OverwriteVector<Triangle> triangles;
  OverwriteVector<TriangleId> triangle_of;  // increasing among those with the same smallest vertex

  std::vector<Triangle> improper;  // the others: neither halfedges nor corners of them are linked
  std::vector<TriangleId> improper_of;

  HalfedgeLinks links;  // of the halfedges on each edge
  // The first halfedge of each irregular edge, increasing. An edge is regular if exactly two
  // triangles with different apexes share it and run through it in opposite directions.
  std::vector<Halfedge> irregular;

  // The corners at each vertex as the halfedges opposite to them, increasing; use corners_at.
  std::vector<std::uint32_t> corner_begin;  // points + 1
  OverwriteVector<Halfedge> corners;

  std::span<const Halfedge> corners_at(VertexId v) const {
    const std::size_t begin = corner_begin[v.index()];
    return {corners.data() + begin, corner_begin[v.index() + 1] - begin};
  }
  VertexId from(Halfedge halfedge) const {
    return triangles[triangle_of_halfedge(halfedge)][next_corner(corner_of_halfedge(halfedge))];
  }
  VertexId to(Halfedge halfedge) const {
    return triangles[triangle_of_halfedge(halfedge)][previous_corner(corner_of_halfedge(halfedge))];
  }
  VertexId apex(Halfedge halfedge) const {
    return triangles[triangle_of_halfedge(halfedge)][corner_of_halfedge(halfedge)];
  }
  // Exactly two triangles at the edge of the halfedge.
  bool has_two_triangles(Halfedge halfedge) const {
    return cocoon::has_two_triangles(links, halfedge);
  }
  // The largest of the halfedges on its edge: each edge has one. links[halfedge] is then the
  // smallest.
  bool is_last(Halfedge halfedge) const { return is_last_at_edge(links, halfedge); }
};

// Throws InputError if a triangle names a vertex that is not there, or if there are more than
// 2^32 / 3 triangles. Complexity: as halfedge_links. Deterministic: a function of the mesh.
LinkedMesh link_mesh(const TriangleMesh& mesh, const Execution& execution = {});

}  // namespace cocoon
