// A mesh as checks and measures of all its neighborhoods want it: a copy numbered so that what is
// near in space is near in memory, with its edges and vertices linked.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/side_links.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct LinkedMesh {
  // Copies, and what the originals are called; ids below are those of the copies.
  IdVector<VertexId, Point> points;  // grouped along a space-filling curve
  IdVector<VertexId, VertexId> vertex_of;
  // Those with three different vertices, by their smallest one.
  OverwriteVector<Triangle> triangles;
  OverwriteVector<TriangleId> triangle_of;  // increasing among those with the same smallest vertex

  std::vector<Triangle> improper;  // the others: neither sides nor corners of them are linked
  std::vector<TriangleId> improper_of;

  SideLinks links;  // of the sides on each edge: side_links.h
  // The first sides of all edges but those with two triangles, not one twice, that run through it
  // in opposite directions; increasing.
  std::vector<SideId> irregular;

  // The corners at each vertex as the sides opposite to them, increasing; use corners_at.
  std::vector<std::uint32_t> corner_begin;  // points + 1
  OverwriteVector<SideId> corners;

  std::span<const SideId> corners_at(VertexId v) const {
    const std::size_t begin = corner_begin[v.index()];
    return {corners.data() + begin, corner_begin[v.index() + 1] - begin};
  }
  VertexId from(SideId side) const {
    return triangles[triangle_of_side(side)][next_corner(corner_of_side(side))];
  }
  VertexId to(SideId side) const {
    return triangles[triangle_of_side(side)][previous_corner(corner_of_side(side))];
  }
  VertexId apex(SideId side) const {
    return triangles[triangle_of_side(side)][corner_of_side(side)];
  }
  // Exactly two triangles at the edge of the side.
  bool is_two_sided(SideId side) const { return links[side] != side && links[links[side]] == side; }
  // The smallest of the sides on its edge: each edge has one.
  bool is_first(SideId side) const {
    SideId other = links[side];
    while (other > side) other = links[other];
    return other == side;
  }
};

// Throws InputError if a triangle names a vertex that is not there, or if there are more than
// 2^32 / 3 triangles. Complexity: as side_links. Deterministic: a function of the mesh.
LinkedMesh link_mesh(const TriangleMesh& mesh, const Execution& execution = {});

}  // namespace cocoon
